#ifndef UNWRAP_PROGRESS_DISPLAY_H
#define UNWRAP_PROGRESS_DISPLAY_H

#include <string>

// Shows on the standard error how far the run is.
class Progress_display
{
public:
  enum class Style
  {
    NONE,
    BAR,  // a line that changes, if the standard error is a terminal
    LINES // a line "PERCENT PHASE" for each change, for another program to read
  };

  explicit Progress_display(Style style);
  Progress_display(const Progress_display&) = delete;
  Progress_display& operator=(const Progress_display&) = delete;
  // Takes the bar away.
  ~Progress_display();

  // `fraction` of the run, from 0 to 1, is done, and `phase` goes on.
  void show(const std::string& phase, double fraction);

private:
  Style m_style;
  std::string m_line;
};

#endif // UNWRAP_PROGRESS_DISPLAY_H
