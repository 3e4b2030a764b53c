// How far the gap shrinks: nominal car, tolerances used up, and with the effect; on the drives from which it was
// learned and on those held out.
#pragma once

#include "diagnose/search.h"

namespace tread {

// Fills how_far, unexplained.share and the overlays of a diagnosis whose causes are named, and warns of what is left
// out of the drives.
void howFar(Diagnosis& diagnosis, Study& study, const Search& found, std::vector<RecordedDrive> held_out);

}  // namespace tread
