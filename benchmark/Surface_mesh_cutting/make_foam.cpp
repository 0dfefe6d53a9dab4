// Makes the level set of a sum of random waves, as generated models are: many handles, several components, and places
// where the surface touches itself. One vertex for each cell of a grid that the surface crosses, two triangles for
// each edge of the grid (surface nets). Takes about two seconds for a million triangles.
//
//   make_foam FILE.off [SIZE [WAVES_PER_SIDE [SEED]]]
//
// SIZE is the number of grid points along each axis; the default, 250, gives about a million triangles.

#include <array>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using Cell = std::array<int, 3>;
using Point = std::array<double, 3>;

// The values of the field at the points of a grid, positive on its border, so that the surface is closed.
class Grid
{
public:
  Grid(int size, double waves_per_side, unsigned seed) : m_size(size), m_values(std::size_t(size) * size * size, 1)
  {
    constexpr int number_of_waves = 24;
    constexpr double level = 0.1, pi = 3.14159265358979323846;
    std::mt19937 random(seed);
    std::normal_distribution<double> frequency(0, 2 * waves_per_side / size);
    std::uniform_real_distribution<double> phase(0, 2 * pi);
    std::vector<float> sums(m_values.size(), 0);
    for(int wave = 0; wave < number_of_waves; ++wave)
    {
      const double a = frequency(random), b = frequency(random), c = frequency(random), t = phase(random);
      const std::complex<double> step = std::polar(1., c);
      for(int i = 0; i < size; ++i)
        for(int j = 0; j < size; ++j)
        {
          std::complex<double> value = std::polar(1., a * i + b * j + t);
          for(int k = 0; k < size; ++k, value *= step)
            sums[index({i, j, k})] += float(value.real());
        }
    }
    for(int i = 1; i + 1 < size; ++i)
      for(int j = 1; j + 1 < size; ++j)
        for(int k = 1; k + 1 < size; ++k)
          m_values[index({i, j, k})] = sums[index({i, j, k})] / 3.5f + float(level);
  }

  std::size_t index(const Cell& c) const
  {
    return (std::size_t(c[0]) * std::size_t(m_size) + std::size_t(c[1])) * std::size_t(m_size) + std::size_t(c[2]);
  }
  double value(const Cell& c) const { return m_values[index(c)]; }
  bool is_inside(const Cell& c) const { return value(c) < 0; }

  // Calls `visit(c)` for all points but the last ones along each axis.
  template <typename Visit>
  void for_each_cell(Visit visit) const
  {
    for(int i = 0; i + 1 < m_size; ++i)
      for(int j = 0; j + 1 < m_size; ++j)
        for(int k = 0; k + 1 < m_size; ++k)
          visit(Cell{{i, j, k}});
  }

private:
  int m_size;
  std::vector<float> m_values;
};

Cell moved(Cell c, int axis, int distance)
{
  c[std::size_t(axis)] += distance;
  return c;
}

// The mean of where the edges of a cell cross the surface; false if none does.
bool find_vertex(const Grid& grid, const Cell& cell, Point& vertex)
{
  int number = 0;
  Point sum = {{0, 0, 0}};
  for(int corner = 0; corner < 8; ++corner)
    for(int axis = 0; axis < 3; ++axis)
    {
      if((corner >> axis & 1) != 0)
        continue;
      const Cell from = {{cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1), cell[2] + (corner >> 2 & 1)}};
      const double v = grid.value(from), w = grid.value(moved(from, axis, 1));
      if((v < 0) == (w < 0))
        continue;
      for(std::size_t i = 0; i < 3; ++i)
        sum[i] += from[i] + (int(i) == axis ? v / (v - w) : 0);
      ++number;
    }
  for(std::size_t i = 0; i < 3 && number > 0; ++i)
    vertex[i] = sum[i] / number;
  return number > 0;
}

} // namespace

int main(int argc, char** argv)
{
  const int size = argc > 2 ? std::atoi(argv[2]) : 250;
  if(argc < 2 || size < 3)
  {
    std::cerr << "usage: " << argv[0] << " FILE.off [SIZE [WAVES_PER_SIDE [SEED]]]\n";
    return EXIT_FAILURE;
  }
  const Grid grid(size, argc > 3 ? std::atof(argv[3]) : 3, argc > 4 ? unsigned(std::atoi(argv[4])) : 0);

  std::vector<int> vertices(std::size_t(size) * std::size_t(size) * std::size_t(size), -1); // per cell
  std::vector<Point> points;
  grid.for_each_cell([&](const Cell& cell)
  {
    Point point;
    if(!find_vertex(grid, cell, point))
      return;
    vertices[grid.index(cell)] = int(points.size());
    points.push_back(point);
  });

  std::vector<std::array<int, 4> > quads;
  grid.for_each_cell([&](const Cell& point)
  {
    for(int axis = 0; axis < 3; ++axis)
      if(grid.is_inside(point) != grid.is_inside(moved(point, axis, 1)))
      {
        const int x = (axis + 1) % 3, y = (axis + 2) % 3;
        std::array<int, 4> quad = {{vertices[grid.index(moved(moved(point, x, -1), y, -1))],
                                    vertices[grid.index(moved(point, y, -1))], vertices[grid.index(point)],
                                    vertices[grid.index(moved(point, x, -1))]}};
        if(!grid.is_inside(point))
          std::swap(quad[1], quad[3]);
        quads.push_back(quad);
      }
  });

  std::ofstream file(argv[1]);
  file << "OFF\n" << points.size() << " " << 2 * quads.size() << " 0\n";
  for(const Point& p : points)
    file << float(p[0]) << " " << float(p[1]) << " " << float(p[2]) << "\n";
  for(const std::array<int, 4>& q : quads)
    file << "3 " << q[0] << " " << q[1] << " " << q[2] << "\n3 " << q[0] << " " << q[2] << " " << q[3] << "\n";
  std::cout << argv[1] << ": " << points.size() << " vertices, " << 2 * quads.size() << " triangles\n";
  return file ? EXIT_SUCCESS : EXIT_FAILURE;
}
