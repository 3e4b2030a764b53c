#include "blind/faults/outsiders.h"

namespace tread::blind::faults {

using key::Family;

const std::vector<Outsider>& outsiders() {
    static const std::vector<Outsider> all = [] {
        std::vector<Outsider> list = firstOutsiders();
        for (Outsider& outsider : secondOutsiders()) list.push_back(std::move(outsider));
        return list;
    }();
    return all;
}

std::vector<const Outsider*> outsiders(Family family) {
    std::vector<const Outsider*> found;
    for (const Outsider& outsider : outsiders()) {
        if (outsider.family == family) found.push_back(&outsider);
    }
    return found;
}

}  // namespace tread::blind::faults
