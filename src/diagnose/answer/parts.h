// The parts of a gap, as they are told and drawn.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnose/answer/diagnosis.h"

namespace tread::diagnose::answer {

// together: what causes explain only jointly, beyond the sum of what each explains alone.
enum class PartKind { tolerances, cause, shared, together, remainder, noise };

struct ToldPart {
    PartKind kind;
    std::vector<std::string> causes = {};  // of a cause, or of what several of them explain
    double share = 0;                      // of the gap of the nominal car; the shares of all parts sum to 1
    std::optional<Part> interval = {};     // where the parts have one
    double drawn = 0;                      // length in a bar of length 1
};

// The parts in their order: tolerances, causes, what causes share, remainder, noise. A cause has the share that it
// explains after all others ("last in"); what several explain is a part of its own. A part that makes the gap larger
// has a negative share, and is drawn as 0.
std::vector<ToldPart> toldParts(const Decomposition& gap);

// "tyre relaxation", "shared by grip and mass"
std::string partInWords(const ToldPart& part);

// Causes with the largest share on its own ("first in") first.
std::vector<CausePart> inOrder(const Decomposition& gap);

// A share of the gap, as a share of what tolerances and noise leave of it.
double shareOfTheRest(const Decomposition& gap, double share);

// What a model closes of the part of the gap that it can close, in words and numbers: "1 - unexplained 1.0 / (100 -
// noise 6.0) = 99 %". Empty where noise is the whole gap. This, of squared gaps, is what "closed" means everywhere
// (D49a).
std::string closedInWords(const Decomposition& gap);
double closedShare(const Decomposition& gap);
// The same of levels, which are roots: (nominal^2 - after^2) / (nominal^2 - floor^2); NaN where nothing can be closed.
double closedShare(const GapLevels& levels, double after);

// Sentences about parts that make the gap larger; empty when there is none.
std::vector<std::string> enlargingInWords(const Decomposition& gap);

// The remainder of the drives that were fitted, by channel and by recording.
Shares remainderOfChannels(const Diagnosis& diagnosis);
Shares remainderOfRecordings(const Diagnosis& diagnosis);

}  // namespace tread::diagnose::answer
