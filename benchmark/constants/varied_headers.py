"""Writes a copy of the headers in which the environment variable VARY changes one constant.

constants.csv lists the constants: `code` is a piece of the file that occurs once, with the value between two @.
VARY=ROW:FACTOR changes the constant of that row (from 0), by its `form`:

    factor   the value times FACTOR
    excess   what the value is above or below 1, times FACTOR
    power    the value to the power of FACTOR: for ratios of series
    (none)   not at all: no result depends on it, or no run gets there

Integers are rounded, and stay positive. Programs write the rows of the constants that they read to the file that
VARY_READ names."""

import csv
import pathlib
import re

FORMS = {"factor": "value * factor", "excess": "1 + (value - 1) * factor", "power": "std::pow(value, factor)"}
MARKED = re.compile("@(.*?)@")

VARIATION = """#ifndef CGAL_VARIATION_H
#define CGAL_VARIATION_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <type_traits>

struct Variation
{
  int row = -1;
  double factor = 1;
  std::array<bool, NUMBER_OF_CONSTANTS> is_read{};

  Variation()
  {
    const char* text = std::getenv("VARY");
    if(text != nullptr && std::sscanf(text, "%d:%lf", &row, &factor) != 2)
      std::abort();
  }

  ~Variation()
  {
    const char* name = std::getenv("VARY_READ");
    std::FILE* file = name == nullptr ? nullptr : std::fopen(name, "w");
    if(file == nullptr)
      return;
    for(std::size_t i = 0; i < is_read.size(); ++i)
      if(is_read[i])
        std::fprintf(file, "%d\\n", int(i));
    std::fclose(file);
  }
};

inline Variation& variation()
{
  static Variation result;
  return result;
}

template <typename Number, typename Form>
Number varied(int row, Number value, Form form)
{
  Variation& v = variation();
  v.is_read[std::size_t(row)] = true;
  if(row != v.row)
    return value;
  const double result = form(double(value), v.factor);
  return std::is_integral<Number>::value ? Number(std::max(1., std::floor(result + 0.5))) : Number(result);
}

#endif // CGAL_VARIATION_H
"""


def read_constants(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def value(constant):
    """As it is in the code."""
    return MARKED.search(constant["code"])[1]


def place(constant, text):
    """Where the value is in the text of the file."""
    code = MARKED.sub(r"\1", constant["code"])
    if text.count(code) != 1:
        raise SystemExit(f"{constant['file']} has {text.count(code)} times '{code}': constants.csv needs an update")
    return text.index(code) + MARKED.search(constant["code"]).start()


def is_real(constant, text, start):
    """Whether the value is a number of type double, which need not have a decimal point."""
    first = start - constant["code"].index("@")
    return "double" in text[text.rindex("\n", 0, first) + 1:text.index("\n", start)]


def varied_text(text, constants):
    """`constants` by row: those of this file."""
    result = text
    for start, row in sorted(((place(c, text), row) for row, c in constants.items()), reverse=True):
        literal = value(constants[row])
        number = f"double({literal})" if is_real(constants[row], text, start) else literal
        form = f"[](double value, double factor) {{ return {FORMS[constants[row]['form']]}; }}"
        result = f"{result[:start]}varied({row}, {number}, {form}){result[start + len(literal):]}"
    lines = result.split("\n")
    for i, line in enumerate(lines):
        if "varied(" in line:
            lines[i] = line.replace("static constexpr", "static inline const").replace("constexpr", "const")
    return "#include <CGAL/variation.h>\n" + "\n".join(lines)


def write_varied_headers(include, copy, constants):
    """Files that are as they should be are not touched, for the sake of builds; those that are gone are removed."""
    rows = {}
    for row, constant in enumerate(constants):
        if constant["form"]:
            rows.setdefault(pathlib.Path("CGAL") / constant["file"], {})[row] = constant
    texts = {source.relative_to(include): source.read_text(encoding="utf-8") for source in include.rglob("*.h")}
    texts.update({name: varied_text(texts[name], rows_of_file) for name, rows_of_file in rows.items()})
    texts[pathlib.Path("CGAL/variation.h")] = VARIATION.replace("NUMBER_OF_CONSTANTS", str(len(constants)))
    for name, text in texts.items():
        write_if_different(copy / name, text)
    for header in set(copy.rglob("*.h")) - {copy / name for name in texts}:
        header.unlink()


def write_if_different(path, text):
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
