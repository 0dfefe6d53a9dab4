// Text about many elements, put together by several threads.

#ifndef UNWRAP_WRITE_IN_BLOCKS_H
#define UNWRAP_WRITE_IN_BLOCKS_H

#include "Number_writer.h"

#include <CGAL/Surface_mesh_parameterization/internal/Execution.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// Writes what `write(begin, end, out)` does for blocks of 0..size-1, in their order.
template <typename Write>
void write_in_blocks(std::size_t size, const Write& write, Number_writer& out)
{
  using namespace CGAL::Surface_mesh_parameterization::internal;
  std::vector<std::string> texts;
  texts.resize(std::size_t(number_of_blocks(int(size))));
  execute_blocks(execution_of<CGAL::Parallel_if_available_tag>(), int(size), [&](int begin, int end)
  {
    Number_writer block;
    write(std::size_t(begin), std::size_t(end), block);
    texts[std::size_t(begin / block_size)] = std::move(block).text();
  });
  std::size_t length = 0;
  for(const std::string& text : texts)
    length += text.size();
  out.reserve(length);
  for(const std::string& text : texts)
    out << text;
}

#endif // UNWRAP_WRITE_IN_BLOCKS_H
