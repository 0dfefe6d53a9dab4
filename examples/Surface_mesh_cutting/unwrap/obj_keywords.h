// The statements of OBJ that bring neither a point nor a polygon.

#ifndef UNWRAP_OBJ_KEYWORDS_H
#define UNWRAP_OBJ_KEYWORDS_H

#include "Data_kinds.h"

#include <cstddef>
#include <optional>
#include <string_view>

struct Obj_keyword
{
  std::string_view word;
  Data_kind kind;
  bool has_names = false;                  // to the end of the line, and maybe with blanks and # in them
  std::optional<std::size_t> first_point = std::nullopt; // which word behind it is the first that refers to a point
};

// Null for a word that is none of them.
const Obj_keyword* find_obj_keyword(std::string_view word);

// Whether a line that begins with this word is a statement, of whatever kind.
bool starts_obj_statement(std::string_view word);

#endif // UNWRAP_OBJ_KEYWORDS_H
