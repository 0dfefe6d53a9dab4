#include "constraint_files.h"

#include "Text_scanner.h"
#include "file_bytes.h"
#include "outcome.h"
#include "text_encoding.h"

#include <cctype>
#include <cmath>
#include <string_view>

namespace {

// Whatever `read(scanner)` finds wrong is told with the name of the file.
template <typename Read>
auto read_file(const std::string& path, Read read)
{
  try
  {
    const std::string bytes = in_utf8(read_bytes(path));
    Text_scanner scanner(without_byte_order_mark(bytes));
    return read(scanner);
  }
  catch(const Failure& failure)
  {
    if(failure.code != Exit_code::UNREADABLE)
      throw;
    throw Failure(failure.code, path + ": " + failure.what());
  }
}

std::vector<int> read_indices(Text_scanner& scanner)
{
  std::vector<int> indices;
  for(std::string_view word = scanner.word_in_line(); !word.empty(); word = scanner.word_in_line())
    indices.push_back(scanner.to_index(word));
  return indices;
}

std::vector<int> read_line(Text_scanner& scanner)
{
  const std::vector<int> indices = read_indices(scanner);
  scanner.skip_line();
  return indices;
}

// Not negative, and infinite only if it says so.
double to_weight(const Text_scanner& scanner, std::string_view word)
{
  const double weight = scanner.to_number(word);
  if(std::isinf(weight) && std::isdigit(static_cast<unsigned char>(word.back())))
    scanner.fail("a weight below 1e308", word);
  if(!(weight >= 0))
    scanner.fail("a weight that is not negative", word);
  return weight;
}

void expect_end_of_line(Text_scanner& scanner)
{
  if(const std::string_view more = scanner.word_in_line(); !more.empty())
    scanner.fail("the end of the line", more);
}

} // namespace

Selection read_selection(const std::string& path)
{
  return read_file(path, [](Text_scanner& scanner)
  {
    Selection selection;
    selection.vertices = read_line(scanner);
    selection.faces = read_line(scanner);
    const std::vector<int> ends = read_indices(scanner);
    if(ends.size() % 2 != 0)
      scanner.fail("the second vertex of an edge", "");
    for(std::size_t i = 0; i < ends.size(); i += 2)
      selection.edges.push_back({ends[i], ends[i + 1]});
    scanner.skip_line();
    if(const std::string_view word = scanner.word(); !word.empty())
      scanner.fail("no more than three lines", word);
    return selection;
  });
}

std::vector<Edge_weight> read_edge_weights(const std::string& path)
{
  return read_file(path, [](Text_scanner& scanner)
  {
    std::vector<Edge_weight> weights;
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
    {
      const int source = scanner.to_index(word), target = scanner.index_in_line();
      const double weight = to_weight(scanner, scanner.word_in_line());
      expect_end_of_line(scanner);
      weights.push_back({{source, target}, weight});
    }
    return weights;
  });
}

Vertex_values read_vertex_values(const std::string& path)
{
  return read_file(path, [](Text_scanner& scanner)
  {
    Vertex_values result;
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
    {
      const std::string_view second = scanner.word_in_line();
      if(result.values.empty())
        result.is_for_all = second.empty();
      else if(result.is_for_all != second.empty())
        scanner.fail(result.is_for_all ? "the end of the line" : "a number behind the vertex", second);
      const std::string_view number = result.is_for_all ? word : second;
      const double value = to_weight(scanner, number);
      if(std::isinf(value))
        scanner.fail("a number that is finite", number);
      result.values.push_back({result.is_for_all ? int(result.values.size()) : scanner.to_index(word), value});
      expect_end_of_line(scanner);
    }
    return result;
  });
}
