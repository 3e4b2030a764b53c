#include "bullet/drop_in/shared_cars.h"

#include <cstring>
#include <mutex>
#include <string_view>
#include <unordered_map>

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

struct Entry {
    CarRecipe recipe;
    std::weak_ptr<const WheeledBody> car;
};

// Cars that are in use, by the hash of their recipes.
class Store {
public:
    MadeCar find(const CarRecipe& recipe, const std::function<WheeledBody()>& make) {
        const std::size_t hash = recipe.hash();
        const std::lock_guard lock(mutex_);
        const auto [begin, end] = entries_.equal_range(hash);
        for (auto at = begin; at != end; ++at) {
            if (!(at->second.recipe == recipe)) continue;
            if (MadeCar car = at->second.car.lock()) return car;
        }
        forget();
        auto car = std::make_shared<const WheeledBody>(make());
        entries_.emplace(hash, Entry{recipe, car});
        return car;
    }

private:
    // Drops what nobody uses any more, whenever the store has doubled: a constant cost for each car that is made.
    void forget() {
        if (entries_.size() < next_look_) return;
        std::erase_if(entries_, [](const auto& entry) { return entry.second.car.expired(); });
        next_look_ = 2 * entries_.size() + kFew;
    }

    static constexpr std::size_t kFew = 16;
    std::mutex mutex_;
    std::unordered_multimap<std::size_t, Entry> entries_;
    std::size_t next_look_ = kFew;
};

}  // namespace

bool CarRecipe::operator==(const CarRecipe& other) const {
    if (wheel_count != other.wheel_count) return false;
    if (std::memcmp(body.data(), other.body.data(), sizeof body) != 0) return false;
    for (std::size_t i = 0; i < wheel_count; ++i)
        if (!(wheels[i] == other.wheels[i])) return false;
    return true;
}

std::size_t CarRecipe::hash() const {
    const auto bytes = [](const auto& numbers) {
        return std::string_view(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    };
    std::size_t hash = std::hash<std::string_view>{}(bytes(body));
    for (std::size_t i = 0; i < wheel_count; ++i)
        hash = 31 * hash + std::hash<std::string_view>{}(bytes(wheels[i].numbers));
    return hash;
}

MadeCar sharedCar(const CarRecipe& recipe, const std::function<WheeledBody()>& make) {
    static Store store;
    return store.find(recipe, make);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
