#ifndef UNWRAP_PROGRESS_BAR_H
#define UNWRAP_PROGRESS_BAR_H

#include <string>

// A line on the standard error that shows how far the run is. Does nothing unless that is a
// terminal.
class Progress_bar
{
public:
  explicit Progress_bar(bool is_wanted);
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;
  // Takes the line away.
  ~Progress_bar();

  // `fraction` of `phase`, from 0 to 1, is done.
  void show(const std::string& phase, double fraction);

private:
  bool m_is_shown;
  std::string m_line;
};

#endif // UNWRAP_PROGRESS_BAR_H
