// Words that somebody may have meant.

#ifndef UNWRAP_NEAR_MISSES_H
#define UNWRAP_NEAR_MISSES_H

#include <string>
#include <vector>

// The words with commas between.
std::string joined(const std::vector<std::string>& words);

// "; did you mean ...?" with the word that differs least, or nothing if none is similar.
std::string suggestion(const std::string& word, const std::vector<std::string>& words);

#endif // UNWRAP_NEAR_MISSES_H
