// What a file is: a YAML file judged by its outermost keys, any other by its name and its beginning.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "base/yaml/document.h"
#include "describable.h"

namespace tread::program {

// The outermost keys; none for what is no mapping.
std::vector<std::string> keysOf(const YamlDocument& document);

// The kind of file whose description has most of the keys; nullptr when none fits or several fit equally.
const Describable* bestMatch(const std::vector<std::string>& keys);

// `"a", "b" and 3 more`, for a message.
std::string foundKeys(const std::vector<std::string>& keys);

// "run" or "results" for what `tread run` itself has written; empty for anything else. As a fault, in a sentence.
std::string_view kindOfOutput(const std::vector<std::string>& keys);
std::string outputFault(const std::vector<std::string>& keys);

// A height field starts with x and y, a log with the time.
bool looksLikeHeightField(std::string_view text);

// Throws LoadError with one sentence when a file or folder is certainly of another kind than those that are wanted
// (words of describables(), "log", "table", "folder", "tir"): what it is, what is expected, what takes it. Silent on
// what does not exist, or is faulty: the reader says why.
void expectKind(const Path& file, std::initializer_list<std::string_view> wanted);

}  // namespace tread::program
