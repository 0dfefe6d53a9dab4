// Tangents of a surface with texture coordinates.

#ifndef UNWRAP_TANGENTS_H
#define UNWRAP_TANGENTS_H

#include <Eigen/Core>

#include <array>
#include <vector>

// The direction in which u grows, of unit length and across the normal, then 1, or -1 in triangles that are clockwise in the
// texture. The product of normal and direction, times that, is the direction in which v grows.
using Tangent = std::array<float, 4>;

// A corner of a triangle. Its `uv`, whose v points up, is that of `uv_vertex`.
struct Tangent_corner
{
  Eigen::Vector3d point, normal;
  Eigen::Vector2d uv;
  int uv_vertex;
};

// Per corner of triangles given one after the other, as MikkTSpace defines them: the mean of the triangles around,
// weighted by their angles. Corners share it where they have the same UV vertex, normal and last component.
std::vector<Tangent> corner_tangents(const std::vector<Tangent_corner>& corners);

// Any one, for vertices without triangles.
Tangent any_tangent(const Eigen::Vector3d& normal);

#endif // UNWRAP_TANGENTS_H
