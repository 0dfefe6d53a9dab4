#include "partner_picture.h"

#include "svg_elements.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

using Point = std::array<double, 2>;

// The pieces of the cut, numbered along the order of its edges.
class Cut_pieces
{
public:
  explicit Cut_pieces(const Layout& layout)
    : m_features(layout.feature_points), m_edges(layout.cut), m_piece(layout.cut.size(), -1)
  {
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      for(const int v : m_edges[e])
        m_incident[v].push_back(int(e));
    for(std::size_t e = 0; e < m_edges.size(); ++e)
      if(m_piece[e] < 0)
        flood(int(e));
  }

  int number() const { return m_number; }
  int piece(std::size_t edge) const { return m_piece[edge]; }

private:
  bool is_end(int v) const
  {
    return m_incident.at(v).size() != 2 || std::binary_search(m_features.begin(), m_features.end(), v);
  }

  void flood(int first)
  {
    std::vector<int> stack(1, first);
    m_piece[std::size_t(first)] = m_number;
    while(!stack.empty())
    {
      const int e = stack.back();
      stack.pop_back();
      for(const int v : m_edges[std::size_t(e)])
        for(const int next : m_incident.at(v))
          if(!is_end(v) && std::exchange(m_piece[std::size_t(next)], m_number) < 0)
            stack.push_back(next);
    }
    ++m_number;
  }

  const std::vector<int>& m_features; // sorted
  const std::vector<Layout::Edge>& m_edges;
  std::map<int, std::vector<int> > m_incident;
  std::vector<int> m_piece; // per cut edge
  int m_number = 0;
};

// Neighbors in number are far apart on the circle of hues.
std::string color_of(int piece)
{
  const int hue = int(piece * 137.508) % 360, lightness = 38 + 14 * (piece / 5 % 2);
  return "hsl(" + std::to_string(hue) + ",75%," + std::to_string(lightness) + "%)";
}

// The borders of the charts by the piece that they are a side of; those of the surface itself come last.
std::vector<std::vector<Layout::Edge> > sides(const Layout& layout, const Cut_pieces& pieces)
{
  std::vector<int> vertices(layout.uv_points.size(), -1); // of UV vertices
  for(std::size_t f = 0; f < layout.triangles.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
      vertices[std::size_t(layout.uv_triangles[f][k])] = layout.triangles[f][k];
  std::map<std::pair<int, int>, int> piece_of_edge;
  for(std::size_t e = 0; e < layout.cut.size(); ++e)
    piece_of_edge[std::minmax(layout.cut[e][0], layout.cut[e][1])] = pieces.piece(e);
  std::vector<std::vector<Layout::Edge> > result(std::size_t(pieces.number()) + 1);
  for(const Layout::Edge& border : layout.chart_borders)
  {
    const int a = vertices[std::size_t(border[0])], b = vertices[std::size_t(border[1])];
    const auto found = piece_of_edge.find(std::minmax(a, b));
    result[std::size_t(found == piece_of_edge.end() ? pieces.number() : found->second)].push_back(border);
  }
  return result;
}

// One label per connected side, in its middle.
std::vector<Layout::Edge> middle_edges(const std::vector<Layout::Edge>& side)
{
  std::map<int, int> next, previous; // border edges by their ends
  for(std::size_t i = 0; i < side.size(); ++i)
  {
    next[side[i][0]] = int(i);
    previous[side[i][1]] = int(i);
  }
  std::vector<char> is_visited(side.size(), 0);
  std::vector<Layout::Edge> middles;
  const auto follow = [&](std::size_t first)
  {
    std::vector<std::size_t> chain;
    for(std::size_t i = first; !std::exchange(is_visited[i], char(1));)
    {
      chain.push_back(i);
      const auto found = next.find(side[i][1]);
      if(found == next.end())
        break;
      i = std::size_t(found->second);
    }
    middles.push_back(side[chain[chain.size() / 2]]);
  };
  for(std::size_t i = 0; i < side.size(); ++i)
    if(previous.count(side[i][0]) == 0)
      follow(i);
  for(std::size_t i = 0; i < side.size(); ++i) // closed
    if(!is_visited[i])
      follow(i);
  return middles;
}

} // namespace

void draw_partners(const Layout& layout, const std::function<Point(const Point&)>& view, Number_writer& out)
{
  const auto place = [&](int uv_vertex) { return view(layout.uv_points[std::size_t(uv_vertex)]); };
  const Cut_pieces pieces(layout);
  const std::vector<std::vector<Layout::Edge> > borders = sides(layout, pieces);
  constexpr double width = 3.5, letter = 11;
  for(int piece = 0; piece <= pieces.number(); ++piece)
  {
    const std::vector<Layout::Edge>& side = borders[std::size_t(piece)];
    const bool is_cut = piece < pieces.number();
    const std::string color = is_cut ? color_of(piece) : "#999";
    out << "<path class=\"" << (is_cut ? "partners" : "border") << "\" fill=\"none\" stroke=\"" << color
        << "\" stroke-width=\"" << Coarse{width} << "\" stroke-linecap=\"round\" d=\"";
    for(const Layout::Edge& edge : side)
      draw_line(place(edge[0]), place(edge[1]), out);
    out << "\"/>\n";
    if(!is_cut)
      continue;
    out << "<g fill=\"" << color << "\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\" font-family=\"sans-serif\" "
           "font-weight=\"bold\" font-size=\"" << Coarse{letter} << "\">\n";
    for(const Layout::Edge& edge : middle_edges(side)) // within the chart, which lies on the left
    {
      const Point a = place(edge[0]), b = place(edge[1]);
      const double length = (std::max)(1e-9, std::hypot(b[0] - a[0], b[1] - a[1]));
      write_text(0.5 * (a[0] + b[0]) + letter * (b[1] - a[1]) / length,
                 0.5 * (a[1] + b[1]) - letter * (b[0] - a[0]) / length + 0.35 * letter, "middle",
                 std::to_string(piece + 1), out);
    }
    out << "</g>\n";
  }
}
