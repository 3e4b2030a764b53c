// Frequency responses from logged input and output: H1 = Sxy / Sxx by Welch's method, or from the Fourier transforms of
// a whole record by the local polynomial method (Pintelon and Schoukens, System Identification: A Frequency Domain
// Approach, 2012, chapter 7; without its transient term, as the record begins and ends at rest).
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "metrics/series.h"

namespace tread {

// How the spectra are estimated.
struct SpectrumSettings {
    // Length of the segments, s, with a Hann window and half overlapping (Welch, IEEE Trans. Audio 15, 1967); 0: the
    // whole record in one, without a window: exact for what begins and ends at rest within the record.
    double segment = 0;
    // Half width of the band about each frequency over which a whole record's transfer function is fitted, Hz.
    double half_band = 0.1;
};

struct FrequencyPoint {
    double frequency;               // Hz
    std::complex<double> transfer;  // output over input
    double coherence;               // 0 to 1; NaN when one estimate alone stands behind it
    double input;                   // power of the input, for comparison
};

// Of each output over the input, at these frequencies, Hz. All series over the same times; the sampling need not be
// even.
std::vector<std::vector<FrequencyPoint>> frequencyResponses(const TimeSeries& input,
                                                            std::span<const TimeSeries> outputs,
                                                            std::span<const double> frequencies,
                                                            const SpectrumSettings& settings);

// Power spectral density at these frequencies, squared unit per Hz, one-sided: its integral over the frequency is the
// variance. Welch's method with segments of that length, s.
std::vector<double> powerSpectralDensity(const TimeSeries& series, std::span<const double> frequencies, double segment);

// How many segments the record gives.
std::size_t segments(const TimeSeries& series, const SpectrumSettings& settings);

}  // namespace tread
