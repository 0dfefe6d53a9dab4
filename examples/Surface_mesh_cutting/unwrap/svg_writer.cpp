#include "svg_writer.h"

#include "Number_writer.h"
#include "Trade_off_plot.h"
#include "base64.h"
#include "distortion_image.h"
#include "partner_picture.h"
#include "stretch.h"
#include "svg_elements.h"

#include <CGAL/Surface_mesh_cutting/internal/packing/Page_tile.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

namespace {

using CGAL::Surface_mesh_cutting::internal::corner_of_page;
using CGAL::Surface_mesh_cutting::internal::tile_of_page;
using Point = std::array<double, 2>;

constexpr double longer_side = 1000, margin = 24, legend_height = 90; // of the picture
constexpr double pixels_per_unit = 1.6;
constexpr std::size_t maximum_number_of_drawn_triangles = 10000;

// From the plane of the layout to the picture.
class View
{
public:
  View(const Layout& layout, std::optional<int> only_page)
  {
    if(only_page)
    {
      const Eigen::Vector2d low = corner_of_page(*only_page);
      m_low = {{low.x(), low.y()}};
      m_scale = longer_side;
      m_size = {{longer_side, longer_side}};
      return;
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point high = {{-infinity, -infinity}};
    m_low = {{infinity, infinity}};
    for(const Point& uv : layout.uv_points)
      for(std::size_t i = 0; i < 2; ++i)
      {
        m_low[i] = (std::min)(m_low[i], uv[i]);
        high[i] = (std::max)(high[i], uv[i]);
      }
    for(const int page : layout.polygon_pages)
      for(std::size_t i = 0; i < 2; ++i)
      {
        const double low = corner_of_page(page)[Eigen::Index(i)];
        m_low[i] = (std::min)(m_low[i], low);
        high[i] = (std::max)(high[i], low + 1);
      }
    const double extent = (std::max)(high[0] - m_low[0], high[1] - m_low[1]);
    m_scale = extent > 0 ? longer_side / extent : 1;
    m_size = {{(high[0] - m_low[0]) * m_scale, (high[1] - m_low[1]) * m_scale}};
  }

  const Point& low() const { return m_low; }
  double scale() const { return m_scale; }
  double width() const { return m_size[0]; }
  double height() const { return m_size[1]; }

  Point operator()(const Point& uv) const
  {
    return {{margin + (uv[0] - m_low[0]) * m_scale,
             margin + m_size[1] - (uv[1] - m_low[1]) * m_scale}};
  }

private:
  Point m_low, m_size;
  double m_scale;
};

void draw_triangles(const Layout& layout, const View& view, Number_writer& out)
{
  const int width = (std::max)(1, int(std::ceil(view.width() * pixels_per_unit)));
  const int height = (std::max)(1, int(std::ceil(view.height() * pixels_per_unit)));
  const Image image = draw_distortion(layout, view.low(), 1 / (view.scale() * pixels_per_unit),
                                      width, height);
  out << "<image x=\"" << Coarse{margin} << "\" y=\""
      << Coarse{margin + view.height() - height / pixels_per_unit}
      << "\" width=\"" << Coarse{width / pixels_per_unit}
      << "\" height=\"" << Coarse{height / pixels_per_unit}
      << "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64,"
      << to_base64(image.to_png()) << "\"/>\n";
}

// The edges of the triangles, where there are few enough to be seen.
void draw_edges(const Layout& layout, const View& view, Number_writer& out)
{
  if(layout.uv_triangles.size() > maximum_number_of_drawn_triangles)
    return;
  out << "<path fill=\"none\" stroke=\"#000\" stroke-opacity=\".25\" stroke-width=\".4\" d=\"";
  for(const Layout::Triangle& triangle : layout.uv_triangles)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const int a = triangle[k], b = triangle[(k + 1) % 3];
      if(a < b) // once per inner edge; those of the border are drawn anyway
        draw_line(view(layout.uv_points[std::size_t(a)]), view(layout.uv_points[std::size_t(b)]),
                  out);
    }
  out << "\"/>\n";
}

// The square of a page, or those of several, with the numbers of their tiles.
void draw_pages(const Layout& layout, std::optional<int> only_page, const View& view, Number_writer& out)
{
  if(layout.polygon_pages.empty() && !only_page)
    return;
  const int first = only_page.value_or(0);
  const int last = only_page ? first : *std::max_element(layout.polygon_pages.begin(), layout.polygon_pages.end());
  out << "<g fill=\"none\" stroke=\"#999\" font-family=\"sans-serif\" font-size=\"13\">\n";
  for(int page = first; page <= last; ++page)
  {
    const Eigen::Vector2d low = corner_of_page(page);
    const Point corner = view({{low.x(), low.y() + 1}});
    out << "<rect x=\"" << Coarse{corner[0]} << "\" y=\"" << Coarse{corner[1]} << "\" width=\"" << Coarse{view.scale()}
        << "\" height=\"" << Coarse{view.scale()} << "\"/>\n";
    write_text(corner[0] + 4, corner[1] + 14, "start", std::to_string(tile_of_page(page)), out);
  }
  out << "</g>\n";
}

void draw_borders(const Layout& layout, const View& view, Number_writer& out)
{
  out << "<path fill=\"none\" stroke=\"#123\" stroke-width=\"1.6\" stroke-linecap=\"round\" d=\"";
  for(const Layout::Edge& edge : layout.chart_borders)
    draw_line(view(layout.uv_points[std::size_t(edge[0])]),
              view(layout.uv_points[std::size_t(edge[1])]), out);
  out << "\"/>\n";
}

// All copies that the cut makes of the feature points.
void draw_feature_points(const Layout& layout, const View& view, Number_writer& out)
{
  std::vector<int> uv_vertices;
  for(std::size_t f = 0; f < layout.triangles.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
      if(std::binary_search(layout.feature_points.begin(), layout.feature_points.end(),
                            layout.triangles[f][k]))
        uv_vertices.push_back(layout.uv_triangles[f][k]);
  std::sort(uv_vertices.begin(), uv_vertices.end());
  uv_vertices.erase(std::unique(uv_vertices.begin(), uv_vertices.end()), uv_vertices.end());

  out << "<g fill=\"#fff\" stroke=\"#07c\" stroke-width=\"2.5\">\n";
  for(const int uv_vertex : uv_vertices)
  {
    const Point center = view(layout.uv_points[std::size_t(uv_vertex)]);
    out << "<circle r=\"5\" cx=\"" << Coarse{center[0]} << "\" cy=\"" << Coarse{center[1]}
        << "\"/>\n";
  }
  out << "</g>\n";
}

std::string caption(const Outcome& outcome)
{
  std::ostringstream text;
  text.precision(4);
  if(outcome.average_energy)
    text << "Mean energy " << *outcome.average_energy << " (" << std::lround(stretch_in_percent(*outcome.average_energy))
         << " % of stretch)";
  if(outcome.maximum_energy)
    text << ", largest " << *outcome.maximum_energy;
  if(outcome.cut_length)
    text << "; length of the cut over bounding box diagonal " << *outcome.cut_length;
  return text.str();
}

void draw_legend(const Outcome& outcome, double top, double width, Number_writer& out)
{
  out << "<defs><linearGradient id=\"scale\">";
  for(std::size_t i = 0; i < distortion_colors.size(); ++i)
  {
    const Image::Color& color = distortion_colors[i];
    out << "<stop offset=\"" << Coarse{100. * double(i) / (distortion_colors.size() - 1)}
        << "%\" stop-color=\"rgb(" << int(color[0]) << "," << int(color[1]) << "," << int(color[2])
        << ")\"/>";
  }
  out << "</linearGradient></defs>\n<rect x=\"" << Coarse{margin} << "\" y=\"" << Coarse{top + 26}
      << "\" width=\"" << Coarse{width} << "\" height=\"14\" fill=\"url(#scale)\" "
         "stroke=\"#999\" stroke-width=\".5\"/>\n"
         "<g font-family=\"sans-serif\" font-size=\"13\" fill=\"#222\">\n";
  write_text(margin, top + 16, "start",
             "How far a triangle is stretched (symmetric Dirichlet energy: 0 % is 4, 12 % is 4.1)", out);
  for(const int percent : {0, 25, 50, 100, 200, 300})
  {
    const double stretch = 1 + percent / 100., energy = 2 * (stretch * stretch + 1 / (stretch * stretch));
    write_text(margin + position_on_scale(energy) * width, top + 55, "middle", std::to_string(percent) + " %", out);
  }
  write_text(margin, top + 78, "start", caption(outcome), out);
  out << "</g>\n";
}

} // namespace

std::string to_svg(const Layout& layout, const Outcome& outcome, const std::string& style, std::optional<int> only_page)
{
  const View view(layout, only_page);
  const Trade_off_plot plot(outcome);
  const double legend_width = 480;
  const double width = 2 * margin + (std::max)(view.width(), legend_width);
  const double legend_top = 2 * margin + view.height(), plot_top = legend_top + legend_height;
  Number_writer out;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << Coarse{width} << " "
      << Coarse{plot_top + (plot.is_empty() ? 0 : Trade_off_plot::height)} << "\">\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  if(style != "partners")
    draw_triangles(layout, view, out);
  draw_edges(layout, view, out);
  draw_pages(layout, only_page, view, out);
  if(style == "partners")
    draw_partners(layout, view, out);
  else
    draw_borders(layout, view, out);
  draw_feature_points(layout, view, out);
  if(style != "partners")
    draw_legend(outcome, legend_top, legend_width, out);
  if(!plot.is_empty())
    plot.draw(margin, plot_top, legend_width, out);
  out << "</svg>\n";
  return std::move(out).text();
}
