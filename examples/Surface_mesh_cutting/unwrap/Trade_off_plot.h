// The lengths and energies that a run went through, as a plot.

#ifndef UNWRAP_TRADE_OFF_PLOT_H
#define UNWRAP_TRADE_OFF_PLOT_H

#include "Number_writer.h"
#include "outcome.h"

#include <array>
#include <optional>
#include <vector>

// To the right the length of the cut over the bounding box diagonal; upward the logarithm of what the
// mean energy has above 4, by which small and large distortions can be told apart.
class Trade_off_plot
{
public:
  static constexpr double height = 340;

  explicit Trade_off_plot(const Outcome& outcome);

  // A single cut is no trade-off.
  bool is_empty() const { return m_points.size() < 2; }

  // `left` and `top` are those of the whole plot, its labels included.
  void draw(double left, double top, double width, Number_writer& out) const;

private:
  using Point = std::array<double, 2>;

  struct Frame
  {
    double left, top, width, height;
  };

  double position(double energy) const; // 0 at the top, 1 at the bottom
  double abscissa(const Frame& frame, double length) const;
  std::vector<double> energy_ticks() const;
  Point place(const Frame& frame, const Point& point) const;
  void draw_axes(const Frame& frame, Number_writer& out) const;
  void draw_bound(const Frame& frame, Number_writer& out) const;
  void draw_points(const Frame& frame, Number_writer& out) const;

  std::vector<Point> m_points; // length and energy
  Point m_result = {};
  std::optional<double> m_bound;
  double m_shortest = 0, m_longest = 0, m_low_energy = 0, m_high_energy = 0; // on the axes
};

#endif // UNWRAP_TRADE_OFF_PLOT_H
