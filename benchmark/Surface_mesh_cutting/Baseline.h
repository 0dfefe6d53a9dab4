// Seconds from an earlier run, or of another program, to compare with.

#ifndef BASELINE_H
#define BASELINE_H

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

inline double median(std::vector<double> values)
{
  if(values.empty())
    return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

class Baseline
{
public:
  Baseline() = default;

  // A CSV file with a line of titles, of which `file` (without folder) and one of `seconds` and `cut_s`
  // are used; of several lines of a file the first.
  explicit Baseline(const std::string& name)
  {
    std::ifstream in(name);
    std::string line;
    if(!std::getline(in, line))
      throw std::runtime_error("cannot read " + name);
    const std::vector<std::string> titles = split(line);
    const auto column = [&](const char* title)
    { return std::size_t(std::find(titles.begin(), titles.end(), title) - titles.begin()); };
    const std::size_t file = column("file");
    const std::size_t seconds = (std::min)(column("seconds"), column("cut_s"));
    while(std::getline(in, line))
    {
      const std::vector<std::string> words = split(line);
      if(!words.at(seconds).empty())
        m_seconds.emplace(words.at(file), std::stod(words[seconds]));
    }
  }

  // How many times as long the baseline took; empty if it does not know the mesh.
  std::optional<double> ratio(const std::string& file, double seconds)
  {
    const auto it = m_seconds.find(file);
    if(it == m_seconds.end() || !(seconds > 0))
      return std::nullopt;
    const double result = it->second / seconds;
    if(it->second >= shortest)
      m_ratios.push_back(result);
    return result;
  }

  void summarize(std::ostream& out) const
  {
    if(m_ratios.empty())
      return;
    double sum_of_logarithms = 0;
    for(double ratio : m_ratios)
      sum_of_logarithms += std::log(ratio);
    out << "against the baseline, where it takes " << shortest << " s or more (" << m_ratios.size()
        << " runs): geometric mean " << std::exp(sum_of_logarithms / double(m_ratios.size())) << " times, least "
        << *std::min_element(m_ratios.begin(), m_ratios.end()) << " times as fast\n";
  }

private:
  static constexpr double shortest = 2; // seconds that can be compared

  static std::vector<std::string> split(const std::string& line)
  {
    std::vector<std::string> words;
    std::istringstream in(line);
    for(std::string word; std::getline(in, word, ',');)
      words.push_back(word);
    return words;
  }

  std::map<std::string, double> m_seconds;
  std::vector<double> m_ratios;
};

#endif // BASELINE_H
