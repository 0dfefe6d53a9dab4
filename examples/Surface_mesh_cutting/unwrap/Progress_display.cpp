#include "Progress_display.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace {

constexpr const char* clear_line = "\r\033[K";

std::string bar(int percent, const std::string& phase)
{
  constexpr int width = 40;
  const std::size_t filled = std::size_t(percent * width / 100);
  return "[" + std::string(filled, '#') + std::string(width - filled, ' ') + "] " + std::to_string(percent) + " % " + phase;
}

} // namespace

Progress_display::Progress_display(Style style)
  : m_style(style == Style::BAR && !isatty(STDERR_FILENO) ? Style::NONE : style)
{}

Progress_display::~Progress_display()
{
  if(m_style == Style::BAR && !m_line.empty())
    std::fputs(clear_line, stderr);
}

void Progress_display::show(const std::string& phase, double fraction)
{
  if(m_style == Style::NONE)
    return;
  const int percent = int((std::min)((std::max)(100 * fraction, 0.), 100.));
  const std::string line = m_style == Style::BAR ? clear_line + bar(percent, phase) : std::to_string(percent) + " " + phase + "\n";
  if(line == m_line)
    return;
  m_line = line;
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}
