#include "pace_format.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <istream>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

// Gives the lines that are not blank one by one, as words, and says where an error is.
class Line_reader
{
  std::istream& m_in;
  std::size_t m_number = 0;
  std::vector<std::string> m_words;

public:
  explicit Line_reader(std::istream& in) : m_in(in) {}

  bool next()
  {
    std::string line;
    while(std::getline(m_in, line)) {
      ++m_number;
      std::istringstream words(line);
      m_words.clear();
      for(std::string word; words >> word;)
        m_words.push_back(word);
      if(!m_words.empty())
        return true;
    }
    return false;
  }

  void require_next()
  {
    if(!next())
      throw std::runtime_error("the file ends too early");
  }

  // words are compared without regard to case
  bool is(std::size_t position, const char* expected) const
  {
    if(position >= m_words.size())
      return false;
    const std::string& word = m_words[position];
    std::size_t i = 0;
    for(; i < word.size() && expected[i] != '\0'; ++i)
      if(std::tolower(static_cast<unsigned char>(word[i])) != std::tolower(static_cast<unsigned char>(expected[i])))
        return false;
    return i == word.size() && expected[i] == '\0';
  }

  void require_size(std::size_t size) const
  {
    if(m_words.size() != size)
      fail("expected " + std::to_string(size) + " words");
  }

  // an integer from `first` to `last`
  std::size_t integer(std::size_t position, std::size_t first, std::size_t last) const
  {
    const std::string& word = m_words[position];
    const bool is_number = word.size() <= 10 && std::all_of(word.begin(), word.end(), [](char c) {
      return c >= '0' && c <= '9';
    });
    const std::size_t value = is_number ? std::size_t(std::stoull(word)) : 0;
    if(!is_number || value < first || value > last)
      fail("'" + word + "' is not an integer between " + std::to_string(first) + " and " + std::to_string(last));
    return value;
  }

  double weight(std::size_t position) const
  {
    const std::string& word = m_words[position];
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    double value = 0.;
    if(!(stream >> value) || !(stream >> std::ws).eof() || !std::isfinite(value) || value < 0.)
      fail("'" + word + "' is not a weight");
    return value;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw std::runtime_error("line " + std::to_string(m_number) + ": " + message);
  }
};

// Counts that a file states are checked, but nothing is allocated for them: memory grows with what the file holds.
const std::size_t maximum_count = 1000000000;

// the file's content with its own vertex numbers
struct Numbered_problem
{
  std::size_t number_of_vertices = 0;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::vector<double> weights;
  std::vector<std::size_t> terminals;
};

std::size_t read_count(Line_reader& reader, const char* keyword)
{
  reader.require_next();
  reader.require_size(2);
  if(!reader.is(0, keyword))
    reader.fail(std::string("expected '") + keyword + "'");
  return reader.integer(1, 0, maximum_count);
}

void check_count(const Line_reader& reader, std::size_t announced, std::size_t found)
{
  if(announced != found)
    reader.fail(std::to_string(announced) + " lines announced, " + std::to_string(found) + " found");
}

void read_graph(Line_reader& reader, Numbered_problem& problem)
{
  const std::size_t n = problem.number_of_vertices = read_count(reader, "Nodes");
  const std::size_t m = read_count(reader, "Edges");
  for(reader.require_next(); !reader.is(0, "END"); reader.require_next()) {
    if(!reader.is(0, "E"))
      reader.fail("expected an edge");
    reader.require_size(4);
    problem.edges.emplace_back(reader.integer(1, 1, n), reader.integer(2, 1, n));
    problem.weights.push_back(reader.weight(3));
  }
  check_count(reader, m, problem.edges.size());
}

void read_terminals(Line_reader& reader, Numbered_problem& problem)
{
  const std::size_t k = read_count(reader, "Terminals");
  for(reader.require_next(); !reader.is(0, "END"); reader.require_next()) {
    if(!reader.is(0, "T"))
      reader.fail("expected a terminal");
    reader.require_size(2);
    problem.terminals.push_back(reader.integer(1, 1, problem.number_of_vertices));
  }
  check_count(reader, k, problem.terminals.size());
}

Problem make_problem(Numbered_problem numbered)
{
  Problem problem;
  problem.names = numbered.terminals;
  for(const auto& edge : numbered.edges) {
    problem.names.push_back(edge.first);
    problem.names.push_back(edge.second);
  }
  std::sort(problem.names.begin(), problem.names.end());
  problem.names.erase(std::unique(problem.names.begin(), problem.names.end()), problem.names.end());
  const auto vertex = [&](std::size_t name) {
    return std::size_t(std::lower_bound(problem.names.begin(), problem.names.end(), name) - problem.names.begin());
  };
  for(auto& edge : numbered.edges)
    edge = std::make_pair(vertex(edge.first), vertex(edge.second));
  for(std::size_t t : numbered.terminals)
    problem.terminals.push_back(vertex(t));
  problem.graph = Graph(numbered.edges.begin(), numbered.edges.end(), numbered.weights.begin(),
                        problem.names.size());
  return problem;
}

} // namespace

Problem read_problem(std::istream& in)
{
  Numbered_problem problem;
  Line_reader reader(in);
  bool has_graph = false, has_terminals = false;
  for(reader.require_next(); !reader.is(0, "EOF"); reader.require_next()) {
    if(!reader.is(0, "SECTION"))
      reader.fail("expected a section");
    if(reader.is(1, "Graph") && !has_graph) {
      read_graph(reader, problem);
      has_graph = true;
    }
    else if(reader.is(1, "Terminals") && has_graph && !has_terminals) {
      read_terminals(reader, problem);
      has_terminals = true;
    }
    else if(reader.is(1, "Graph") || reader.is(1, "Terminals"))
      reader.fail("section out of order");
    else
      while(!reader.is(0, "END")) // sections that only describe the graph
        reader.require_next();
  }
  if(!has_graph || !has_terminals)
    throw std::runtime_error("no graph or no terminals");
  return make_problem(std::move(problem));
}
