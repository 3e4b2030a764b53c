// The tyre that the tests share: vehicles/tyres/car_205_60R15.yaml, read by its lines "name: number" alone, so that a
// fault of the product's reader cannot hide in the tests of the tyre.
#pragma once

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "base/fields/numbers.h"
#include "places/places.h"
#include "tread/tyre.h"
#include "vehicle/fields.h"

namespace reference {

inline tread::TyreParams car205() {
    std::ifstream file(tread::sourceFile("vehicles/tyres/car_205_60R15.yaml"));
    std::map<std::string, double> values;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        std::string name;
        double value = 0;
        if (words >> name >> value && name.back() == ':') values[name.substr(0, name.size() - 1)] = value;
    }
    tread::TyreParams tyre;
    tyre.name = "car_205_60R15";
    for (const tread::Number& number : tread::numbers(tyre.parameters)) {
        if (!values.contains(number.path)) throw std::runtime_error("car_205_60R15.yaml lacks " + number.path);
        *number.value = values.at(number.path);
    }
    return tyre;
}

// Coefficients of ply-steer, conicity and whatever else tells left from right: a mirror image changes their sign.
inline auto leftRightAsymmetry(tread::TyreCoefficients& p) {
    return std::array{&p.pEy3, &p.pHy1, &p.pHy2, &p.pVy1, &p.pVy2, &p.rBy3, &p.rHx1, &p.rVy1, &p.rVy2,
                      &p.qBz4, &p.qDz3, &p.qDz6, &p.qDz7, &p.qEz4, &p.qHz1, &p.qHz2, &p.ssz1};
}

// What turns right on the given tyre turns left on this one.
inline tread::TyreParams mirrored(tread::TyreParams tyre) {
    for (double* odd : leftRightAsymmetry(tyre.parameters)) *odd = -*odd;
    return tyre;
}

// The same tyre alike to the left and right, driven and braked.
inline tread::TyreParams unshifted(tread::TyreParams tyre) {
    tread::TyreCoefficients& p = tyre.parameters;
    for (double* odd : leftRightAsymmetry(p)) *odd = 0;
    for (double* odd : {&p.pHx1, &p.pHx2, &p.pVx1, &p.pVx2, &p.pEx4, &p.rHy1}) *odd = 0;
    return tyre;
}

}  // namespace reference
