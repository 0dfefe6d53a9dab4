// The library three.js, with which the page of --html draws.

#ifndef UNWRAP_THREE_JS_H
#define UNWRAP_THREE_JS_H

#include <string>

bool has_three_js();

// Its text. Requires `has_three_js()`.
std::string three_js();

#endif // UNWRAP_THREE_JS_H
