#include "Trade_off_plot.h"

#include "svg_elements.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace {

constexpr double ideal = 4;

// 1, 2 or 5 times a power of ten, so that at most `number` of them fit into `extent`.
double tick_distance(double extent, int number)
{
  const double power = std::pow(10, std::floor(std::log10(extent / number)));
  for(const double factor : {1., 2., 5.})
    if(factor * power * number >= extent)
      return factor * power;
  return 10 * power;
}

// Multiples of such a distance from `low` to `high`.
std::vector<double> ticks(double low, double high, int number)
{
  const double step = tick_distance(high - low, number);
  std::vector<double> result;
  for(double i = std::ceil(low / step); i * step <= high; ++i)
    result.push_back(i * step + 0.); // not -0
  return result;
}

std::string to_label(double number)
{
  std::ostringstream text;
  text.precision(8);
  text << number;
  return text.str();
}

void draw_circle(const std::array<double, 2>& center, double radius, Number_writer& out)
{
  out << "<circle cx=\"" << Coarse{center[0]} << "\" cy=\"" << Coarse{center[1]} << "\" r=\""
      << Coarse{radius} << "\"/>\n";
}

} // namespace

Trade_off_plot::Trade_off_plot(const Outcome& outcome)
  : m_points(outcome.trade_offs), m_bound(outcome.maximum_average_distortion)
{
  // What no map is better than has no logarithm.
  m_points.erase(std::remove_if(m_points.begin(), m_points.end(),
                                [](const Point& p) { return !(p[1] > ideal) || !std::isfinite(p[1]); }),
                 m_points.end());
  if(is_empty())
    return;
  m_result = {{outcome.cut_length.value_or(0), outcome.average_energy.value_or(ideal)}};
  m_low_energy = m_high_energy = m_bound.value_or(m_points.front()[1]);
  m_shortest = m_longest = m_result[0];
  for(const Point& p : m_points)
  {
    m_shortest = (std::min)(m_shortest, p[0]);
    m_longest = (std::max)(m_longest, p[0]);
    m_low_energy = (std::min)(m_low_energy, p[1]);
    m_high_energy = (std::max)(m_high_energy, p[1]);
  }
  constexpr double margin = 1.25, length_margin = 0.06;
  const double more = length_margin * (m_longest > m_shortest ? m_longest - m_shortest : (std::max)(m_longest, 1.));
  m_shortest -= more;
  m_longest += more;
  m_low_energy = ideal + (m_low_energy - ideal) / margin;
  m_high_energy = ideal + (m_high_energy - ideal) * margin;
}

double Trade_off_plot::position(double energy) const
{
  return std::log((m_high_energy - ideal) / (energy - ideal))
       / std::log((m_high_energy - ideal) / (m_low_energy - ideal));
}

Trade_off_plot::Point Trade_off_plot::place(const Frame& frame, const Point& point) const
{
  return {{abscissa(frame, point[0]), frame.top + frame.height * position(point[1])}};
}

double Trade_off_plot::abscissa(const Frame& frame, double length) const
{
  return frame.left + frame.width * (length - m_shortest) / (m_longest - m_shortest);
}

// Round numbers where they are few enough; over several decades, those that are round above 4.
std::vector<double> Trade_off_plot::energy_ticks() const
{
  constexpr double narrow = 6;
  if(m_high_energy - ideal < narrow * (m_low_energy - ideal))
    return ticks(m_low_energy, m_high_energy, 6);
  std::vector<double> result;
  for(double power = 1e-6; power < 1e6; power *= 10)
    for(const double factor : {1., 2., 5.})
      result.push_back(ideal + factor * power);
  return result;
}

void Trade_off_plot::draw_axes(const Frame& frame, Number_writer& out) const
{
  constexpr double letter = 13; // height
  const double right = frame.left + frame.width, bottom = frame.top + frame.height;
  Number_writer lines;
  double last = bottom + letter; // of the labels
  for(const double energy : energy_ticks())
  {
    const double y = frame.top + frame.height * position(energy);
    if(energy < m_low_energy || energy > m_high_energy || last - y < letter)
      continue;
    draw_line({{frame.left, y}}, {{right, y}}, lines);
    write_text(frame.left - 6, y + 4.5, "end", to_label(energy), out);
    last = y;
  }
  for(const double length : ticks(m_shortest, m_longest, 8))
  {
    const double x = abscissa(frame, length);
    draw_line({{x, frame.top}}, {{x, bottom}}, lines);
    write_text(x, bottom + 17, "middle", to_label(length), out);
  }
  out << "<path fill=\"none\" stroke=\"#ddd\" d=\"" << lines.text() << "\"/>\n";
  write_text(frame.left + frame.width / 2, bottom + 38, "middle",
             "length of the cut over bounding box diagonal", out);
}

void Trade_off_plot::draw_bound(const Frame& frame, Number_writer& out) const
{
  if(!m_bound)
    return;
  const double y = frame.top + frame.height * position(*m_bound);
  out << "<path class=\"bound\" fill=\"none\" stroke=\"#c30\" stroke-dasharray=\"6 4\" d=\"";
  draw_line({{frame.left, y}}, {{frame.left + frame.width, y}}, out);
  out << "\"/>\n<g fill=\"#c30\">\n";
  write_text(frame.left + 6, y - 5, "start", "asked for: " + to_label(*m_bound), out);
  out << "</g>\n";
}

void Trade_off_plot::draw_points(const Frame& frame, Number_writer& out) const
{
  out << "<path class=\"tradeoff\" fill=\"none\" stroke=\"#07c\" stroke-width=\"1.5\" d=\"";
  for(std::size_t i = 0; i + 1 < m_points.size(); ++i)
    draw_line(place(frame, m_points[i]), place(frame, m_points[i + 1]), out);
  out << "\"/>\n<g class=\"tradeoff\" fill=\"#07c\">\n";
  for(const Point& p : m_points)
    draw_circle(place(frame, p), 2.5, out);
  out << "</g>\n<g class=\"result\" fill=\"#fff\" stroke=\"#07c\" stroke-width=\"2.5\">\n";
  draw_circle(place(frame, m_result), 5, out);
  out << "</g>\n";
}

void Trade_off_plot::draw(double left, double top, double width, Number_writer& out) const
{
  constexpr double title = 44, labels = 58;
  const Frame frame = {left + labels, top + title, width - labels, height - title - labels};
  out << "<g font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n";
  write_text(left, top + 24, "start", "Mean energy of the cuts that were tried on the way", out);
  draw_axes(frame, out);
  draw_bound(frame, out);
  draw_points(frame, out);
  out << "</g>\n";
}
