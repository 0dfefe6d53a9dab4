#include "Progress_bar.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace {

constexpr const char* clear_line = "\r\033[K";

} // namespace

Progress_bar::Progress_bar(bool is_wanted) : m_is_shown(is_wanted && isatty(STDERR_FILENO)) {}

Progress_bar::~Progress_bar()
{
  if(!m_line.empty())
    std::fputs(clear_line, stderr);
}

void Progress_bar::show(const std::string& phase, double fraction)
{
  if(!m_is_shown)
    return;
  constexpr int width = 40;
  const int percent = int((std::min)((std::max)(100 * fraction, 0.), 100.));
  const std::size_t filled = std::size_t(percent * width / 100);
  const std::string line = "[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] "
                           + std::to_string(percent) + " % " + phase;
  if(line == m_line)
    return;
  m_line = line;
  std::fprintf(stderr, "%s%s", clear_line, line.c_str());
  std::fflush(stderr);
}
