// What the fuzzer and the replay of its corpus do with the state of a car that goes through the C interface: bytes as
// they are, and a sound state in which some bytes are others and the checksum fits. The car takes it or refuses it with
// a sentence; then it goes on or breaks.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/demand.h"
#include "host/snapshot.h"
#include "places/places.h"
#include "tread/c_api.h"

namespace tread::fuzz {

class CarWithHostileState {
public:
    CarWithHostileState() {
        demand(car_ != nullptr);
        const tread_start start{sizeof(tread_start), 0, 0, 0, 20, nullptr};
        demand(tread_car_start(car_.get(), &start) == TREAD_OK);
        demand(tread_car_advance(car_.get(), 0.02) == TREAD_OK);
        sound_.resize(tread_car_state_size(car_.get()));
        demand(tread_car_get_state(car_.get(), sound_.data(), sound_.size()) == TREAD_OK);
    }

    // True when the car took the state and went on.
    bool take(std::string_view bytes) {
        const bool bare = goOn(std::as_bytes(std::span(bytes)));
        return goOn(changed(bytes)) || bare;
    }

private:
    // The bytes say, again and again: where (2 bytes, modulo the size), how many (1 byte: 1 to 8), and which.
    std::vector<std::byte> changed(std::string_view bytes) const {
        constexpr std::size_t kContent = 32, kSum = 24;  // in the bytes of a snapshot
        std::vector<std::byte> state = sound_;
        for (std::size_t i = 0; i + 3 < bytes.size();) {
            const auto at = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
            std::size_t place = kContent + (at(i) + 256u * at(i + 1)) % (state.size() - kContent);
            const std::size_t end = std::min(bytes.size(), i + 4 + at(i + 2) % 8);
            for (i += 3; i < end; ++i) {
                if (place < state.size()) state[place++] = static_cast<std::byte>(bytes[i]);
            }
        }
        const std::uint64_t sum = host::hashOf(std::span(state).subspan(kContent));
        std::memcpy(state.data() + kSum, &sum, sizeof sum);
        return state;
    }

    bool goOn(std::span<const std::byte> state) {
        if (tread_car_set_state(car_.get(), state.data(), state.size()) != TREAD_OK) {
            demand(*tread_car_error(car_.get()) != '\0');
            return false;
        }
        const tread_status status = tread_car_advance(car_.get(), 0.002);
        if (status != TREAD_OK) {
            demand(*tread_car_error(car_.get()) != '\0');
            return false;
        }
        outputs_.resize(tread_output_count());
        demand(tread_car_outputs(car_.get(), outputs_.data(), outputs_.size()) == TREAD_OK);
        return std::all_of(outputs_.begin(), outputs_.end(), [](double value) { return std::isfinite(value); });
    }

    std::unique_ptr<tread_car, decltype(&tread_car_free)> car_{
        tread_car_load(sourceFile("vehicles/compact.yaml").c_str(), nullptr, nullptr, 0), tread_car_free};
    std::vector<std::byte> sound_;
    std::vector<double> outputs_;
};

inline bool takeHostileState(std::string_view bytes) {
    static CarWithHostileState car;
    return car.take(bytes);
}

}  // namespace tread::fuzz
