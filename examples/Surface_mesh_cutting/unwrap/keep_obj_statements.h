// Keeps what an OBJ file says besides its geometry while it is read.

#ifndef UNWRAP_KEEP_OBJ_STATEMENTS_H
#define UNWRAP_KEEP_OBJ_STATEMENTS_H

#include "Polygon_soup.h"
#include "Text_scanner.h"
#include "obj_keywords.h"

#include <string_view>

// What follows the coordinates of the latest point: a weight or a color.
void keep_point_end(Text_scanner scanner, Polygon_soup& soup);

// `word` is point/texture/normal, for the latest corner.
void keep_normal_index(std::string_view word, Polygon_soup& soup);

// The next words are a normal.
void keep_normal(Text_scanner& scanner, Polygon_soup& soup);

// A statement that brings neither a point nor a polygon; null stands for an unknown one. Points come first when it is
// written again, so it gets indices that are not relative.
void keep_statement(std::string_view word, const Obj_keyword* keyword, Text_scanner& scanner, Polygon_soup& soup);

// `text` starts with #.
void keep_comment(std::string_view text, Polygon_soup& soup);

// Drops what is of no use: normals that no corner has, and indices of those that do not exist.
void complete_looks(Polygon_soup& soup);

#endif // UNWRAP_KEEP_OBJ_STATEMENTS_H
