// A command line, one argument per line, or a file of constraints: the first byte says which.

#include "constraint_files.h"
#include "options.h"
#include "outcome.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

void parse(const std::string& text)
{
  std::vector<std::string> words(1, "unwrap");
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);)
    words.push_back(line);
  std::vector<char*> arguments;
  for(std::string& word : words)
    arguments.push_back(&word[0]);
  arguments.push_back(nullptr);
  parse_command_line(int(words.size()), arguments.data());
}

template <typename Read>
void read_file(const std::string& text, Read read)
{
  static const std::string path
    = (std::filesystem::temp_directory_path() / ("fuzz_arguments." + std::to_string(getpid()))).string();
  std::ofstream(path, std::ios::binary) << text;
  try
  {
    read(path);
  }
  catch(const Failure&)
  {
    // refused with a reason
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch(data[0] % 4)
  {
    case 0: parse(text); break;
    case 1: read_file(text, read_selection); break;
    case 2: read_file(text, read_edge_weights); break;
    case 3: read_file(text, read_vertex_values); break;
  }
  return 0;
}
