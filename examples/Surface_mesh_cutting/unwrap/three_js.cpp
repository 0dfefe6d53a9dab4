#include "three_js.h"

#ifdef UNWRAP_HOLDS_THREE_JS

#include "three_js_text.h"

bool has_three_js()
{
  return true;
}

std::string three_js()
{
  return std::string(three_js_text, sizeof(three_js_text) - 1);
}

#else

#include "file_bytes.h"

#include <filesystem>
#include <system_error>

#ifndef UNWRAP_THREE_JS
#define UNWRAP_THREE_JS ""
#endif

bool has_three_js()
{
  std::error_code error;
  return std::filesystem::is_regular_file(UNWRAP_THREE_JS, error);
}

std::string three_js()
{
  return read_bytes(UNWRAP_THREE_JS);
}

#endif // UNWRAP_HOLDS_THREE_JS
