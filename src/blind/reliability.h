// How far shares and stated probabilities can be trusted.
#pragma once

#include <vector>

namespace tread {

struct Interval {
    double low = 0, high = 1;
};

// Wilson's score interval of a share, 95 % (Wilson 1927); all of [0, 1] when nothing was tried.
Interval wilson(int hits, int of);

// What a diagnosis claims with which probability, and whether that is so.
struct Claim {
    double probability = 0;
    bool right = false;
};
struct ReliabilityBin {
    double from = 0, to = 0;
    int claims = 0, right = 0;
    double stated = 0;  // mean
};
std::vector<ReliabilityBin> reliability(const std::vector<Claim>& claims, int bins = 10);
// Mean difference between what is stated and what is so, weighted by the claims in each bin.
double calibrationError(const std::vector<ReliabilityBin>& bins);

}  // namespace tread
