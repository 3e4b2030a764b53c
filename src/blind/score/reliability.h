// Confidence intervals of shares, and calibration of stated probabilities.
#pragma once

#include <vector>

namespace tread::blind::score {

struct Interval {
    double low = 0, high = 1;
};

// 95 % score interval of a share (Wilson 1927); [0, 1] if `of` is 0.
Interval wilson(int hits, int of);

// A claim of a diagnosis.
struct Claim {
    double probability = 0;  // as stated
    bool right = false;
};
struct ReliabilityBin {
    double from = 0, to = 0;
    int claims = 0, right = 0;
    double stated = 0;   // mean stated probability
    double scatter = 0;  // mean of |right - claims stated| if each claim were right as often as it states
};
std::vector<ReliabilityBin> reliability(const std::vector<Claim>& claims, int bins = 10);
// Expected calibration error: mean absolute difference between stated probability and share of right claims, weighted
// by the claims in each bin.
double calibrationError(const std::vector<ReliabilityBin>& bins);
// The one that as many perfectly calibrated claims show on average: few claims scatter.
double calibrationErrorByChance(const std::vector<ReliabilityBin>& bins);

}  // namespace tread::blind::score
