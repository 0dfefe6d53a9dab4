// The result as one page that needs no network.

#ifndef UNWRAP_HTML_WRITER_H
#define UNWRAP_HTML_WRITER_H

#include "Layout.h"
#include "options.h"

#include <string>

// Throws a `Failure` with `Exit_code::USAGE` where three.js, which the page is made with, is not installed.
void check_page_can_be_made();

// `report` is what `to_json()` made of the same run: the page shows its numbers.
std::string to_html(const Layout& layout, const std::string& report, const Options& options);

#endif // UNWRAP_HTML_WRITER_H
