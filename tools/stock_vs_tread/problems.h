// The known problems of Bullet's stock vehicle, each measured on it and on tread's in the same scene.
#pragma once

#include <string>
#include <vector>

namespace problems {

struct Row {
    std::string problem;
    double stock;
    double tread;
    std::string unit;
    double lowest;  // that tread must give
    double highest;
};
using Rows = std::vector<Row>;

void standing(Rows& rows);  // standing.cpp: slopes, shaking, sleep
void driving(Rows& rows);   // driving.cpp: grip, spin, frame rates
void tipping(Rows& rows);   // tipping.cpp: heights, bounces, jumps, axes
void grounds(Rows& rows);   // grounds.cpp: what one may drive on

}  // namespace problems
