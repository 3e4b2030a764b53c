#include "bullet/ground/near_objects.h"

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <LinearMath/btAabbUtil2.h>

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

struct Collect : btBroadphaseAabbCallback {
    explicit Collect(std::vector<btBroadphaseProxy*>& o) : objects(o) {}
    bool process(const btBroadphaseProxy* object) override {
        objects.push_back(const_cast<btBroadphaseProxy*>(object));
        return true;
    }
    std::vector<btBroadphaseProxy*>& objects;
};

}  // namespace

bool Box::contains(const btVector3& point) const {
    return TestPointAgainstAabb2(low, high, point);
}

bool Box::meets(const btBroadphaseProxy& object) const {
    return TestAabbAgainstAabb2(low, high, object.m_aabbMin, object.m_aabbMax);
}

void NearObjects::find(const btCollisionWorld& world, const Box& within) {
    box = within;
    known = true;
    objects.clear();
    Collect collect(objects);
    const_cast<btCollisionWorld&>(world).getBroadphase()->aabbTest(box.low, box.high, collect);
}
}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
