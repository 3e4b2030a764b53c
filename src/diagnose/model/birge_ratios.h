// Noise that a model leaves in each channel, over what is expected. Noise that is told too small, or an error of the
// model that no force explains, then weakens only the evidence that stands on the channels concerned.
#pragma once

#include <map>
#include <string>

#include "diagnose/model/channel_squares.h"

namespace tread::diagnose::model {

class BirgeRatios {
public:
    // Of a model with these rows. `squares`: beside its remainder.
    BirgeRatios(Drives drives, const Uncertainty& uncertainty, const ChannelSquares& squares, const Rows& rows);

    // Squared ratio for the difference between two models: the mean over the channels, weighted by the squares by which
    // they differ there (D27a).
    double between(const Rows& one, const Rows& other) const;

private:
    std::map<std::string, double> ofChannels(const Rows& whitened) const;

    Drives drives_;
    const Uncertainty& uncertainty_;
    const ChannelSquares& squares_;
    std::map<std::string, double> squared_;  // by channel, at least 1
};

}  // namespace tread::diagnose::model
