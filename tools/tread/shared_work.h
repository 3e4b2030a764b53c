// Options of commands whose work several processes share.
#pragma once

#include <string>

#include "store/shared_work.h"
#include "terminal.h"

namespace tread::program {

// "2/8": the second of eight parts; empty: all. Throws LoadError.
Shard shardOf(const std::string& text);

// Work that stops at Ctrl-C, warns on standard error and shows its progress.
WorkOptions workOptions(int threads, const std::string& shard, Progress& progress);

}  // namespace tread::program
