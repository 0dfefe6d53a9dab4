#include "obj_keywords.h"

#include <algorithm>
#include <iterator>

namespace {

using Kind = Data_kind;

constexpr Obj_keyword keywords[] = {
  {"g", Kind::GROUPS, true}, {"o", Kind::GROUPS, true}, {"s", Kind::SMOOTHING_GROUPS}, {"mg", Kind::SMOOTHING_GROUPS},
  {"usemtl", Kind::MATERIALS, true}, {"usemap", Kind::MATERIALS, true}, {"mtllib", Kind::MATERIAL_FILES, true},
  {"maplib", Kind::MATERIAL_FILES, true}, {"l", Kind::LINES, false, 0}, {"p", Kind::POINTS, false, 0},
  {"bevel", Kind::DISPLAY_SETTINGS}, {"c_interp", Kind::DISPLAY_SETTINGS}, {"d_interp", Kind::DISPLAY_SETTINGS},
  {"lod", Kind::DISPLAY_SETTINGS}, {"shadow_obj", Kind::DISPLAY_SETTINGS}, {"trace_obj", Kind::DISPLAY_SETTINGS},
  {"call", Kind::DISPLAY_SETTINGS}, {"csh", Kind::DISPLAY_SETTINGS},
  // Curves and surfaces.
  {"ctech", Kind::CURVES_AND_SURFACES}, {"stech", Kind::CURVES_AND_SURFACES}, {"vp", Kind::CURVES_AND_SURFACES},
  {"cstype", Kind::CURVES_AND_SURFACES}, {"deg", Kind::CURVES_AND_SURFACES}, {"bmat", Kind::CURVES_AND_SURFACES},
  {"step", Kind::CURVES_AND_SURFACES}, {"curv", Kind::CURVES_AND_SURFACES, false, 2},
  {"curv2", Kind::CURVES_AND_SURFACES}, {"surf", Kind::CURVES_AND_SURFACES, false, 4},
  {"parm", Kind::CURVES_AND_SURFACES}, {"trim", Kind::CURVES_AND_SURFACES}, {"hole", Kind::CURVES_AND_SURFACES},
  {"scrv", Kind::CURVES_AND_SURFACES}, {"sp", Kind::CURVES_AND_SURFACES}, {"end", Kind::CURVES_AND_SURFACES},
  {"con", Kind::CURVES_AND_SURFACES}, {"vc", Kind::CURVES_AND_SURFACES},
  // The same in old files.
  {"bsp", Kind::CURVES_AND_SURFACES, false, 0}, {"bzp", Kind::CURVES_AND_SURFACES, false, 0},
  {"cdc", Kind::CURVES_AND_SURFACES, false, 0}, {"cdp", Kind::CURVES_AND_SURFACES, false, 0},
  {"res", Kind::CURVES_AND_SURFACES}, {"surf_1", Kind::CURVES_AND_SURFACES}, {"surf_2", Kind::CURVES_AND_SURFACES},
  {"q0_1", Kind::CURVES_AND_SURFACES}, {"q0_2", Kind::CURVES_AND_SURFACES}, {"q1_1", Kind::CURVES_AND_SURFACES},
  {"q1_2", Kind::CURVES_AND_SURFACES}, {"curv2d_1", Kind::CURVES_AND_SURFACES},
  {"curv2d_2", Kind::CURVES_AND_SURFACES}, {"$", Kind::COMMENTS, true} // of the early nineties
};

} // namespace

const Obj_keyword* find_obj_keyword(std::string_view word)
{
  if(word.substr(0, 1) == "$") // whatever follows
    word = word.substr(0, 1);
  const auto found = std::find_if(std::begin(keywords), std::end(keywords),
                                  [&](const Obj_keyword& keyword) { return keyword.word == word; });
  return found == std::end(keywords) ? nullptr : found;
}

bool starts_obj_statement(std::string_view word)
{
  return word == "v" || word == "vt" || word == "vn" || word == "f" || word == "fo" || find_obj_keyword(word) != nullptr;
}
