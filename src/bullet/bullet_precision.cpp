#include "tread/bullet_precision.h"

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <cstdio>
#include <cstdlib>

namespace tread {

inline namespace TREAD_BULLET_PRECISION {

namespace {

#ifdef BT_USE_DOUBLE_PRECISION
constexpr const char* kOtherBullet =
    "tread: this program links tread for Bullet in double precision, but runs with Bullet in single precision. Link "
    "tread::tread_float (pkg-config tread-float), or no other Bullet than tread's own (not find_package(Bullet)).\n";
#else
constexpr const char* kOtherBullet =
    "tread: this program links tread for Bullet in single precision, but runs with Bullet in double precision. Link "
    "tread::tread (pkg-config tread), or no other Bullet than tread's own.\n";
#endif

}  // namespace

// Names without a number in them are the same in both Bullets: that of the first library in the program is taken.
// Bullet's fixed body is one of these, and how much of it is written to a file tells the precision of its maker.
bool requireSameBullet() {
    static const bool same =
        btTypedConstraint::getFixedBody().calculateSerializeBufferSize() == int{sizeof(btRigidBodyData)};
    if (!same) {
        std::fputs(kOtherBullet, stderr);
        std::_Exit(EXIT_FAILURE);  // without Bullet's destructors
    }
    return same;
}

}  // namespace TREAD_BULLET_PRECISION
}  // namespace tread
