// Parts of random gluings of triangles against a search from each lowest triangle.

#include "../BGL/check.h"

#include <CGAL/Surface_mesh_parameterization/internal/chart/Corner_table.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <random>
#include <vector>

namespace connected_parts_test {

using namespace CGAL::Surface_mesh_parameterization::internal;

// Glues random sides of triangles in pairs.
std::vector<int> random_opposites(int number_of_triangles, int number_of_pairs, std::mt19937& generator)
{
  std::vector<int> sides(3 * number_of_triangles), opposites(sides.size(), -1);
  std::iota(sides.begin(), sides.end(), 0);
  std::shuffle(sides.begin(), sides.end(), generator);
  for(int i = 0; i < number_of_pairs; ++i)
  {
    opposites[sides[2 * i]] = sides[2 * i + 1];
    opposites[sides[2 * i + 1]] = sides[2 * i];
  }
  return opposites;
}

void search(const std::vector<int>& opposites, const std::vector<char>& is_excluded, int t, int number,
            std::vector<int>& part)
{
  std::vector<int> stack = {t};
  while(!stack.empty())
  {
    t = stack.back();
    stack.pop_back();
    if(is_excluded[t] || part[t] >= 0)
      continue;
    part[t] = number;
    for(int h = 3 * t; h < 3 * t + 3; ++h)
      if(opposites[h] >= 0)
        stack.push_back(opposites[h] / 3);
  }
}

void test_parts(const std::vector<int>& opposites, const std::vector<char>& is_excluded, const Connected_parts& parts)
{
  std::vector<int> expected(is_excluded.size(), -1);
  int number = 0;
  for(int t = 0; t < int(expected.size()); ++t)
    if(!is_excluded[t] && expected[t] < 0)
      search(opposites, is_excluded, t, number++, expected);
  CHECK(parts.number == number);
  CHECK(parts.part == expected);
}

} // namespace connected_parts_test

int main()
{
  using namespace connected_parts_test;
  const unsigned seed = CGAL::get_default_random().get_seed();
  std::cout << "seed " << seed << std::endl;
  CGAL::Random random(seed);
  std::mt19937 generator(seed);
  for(int i = 0; i < 2000; ++i)
  {
    const int n = random.get_int(0, 60);
    const std::vector<int> opposites = random_opposites(n, random.get_int(0, 3 * n / 2 + 1), generator);
    std::vector<char> is_excluded(n, 0);
    test_parts(opposites, is_excluded, Connected_parts(opposites));
    const double share = random.get_double();
    for(char& e : is_excluded)
      e = random.get_double() < share;
    test_parts(opposites, is_excluded, Connected_parts(opposites, [&](int t) { return bool(is_excluded[t]); }));
  }
  return test::exit_status();
}
