#include "vehicle/fields.h"

#include "base/fields/implausible.h"
#include "base/fields/numbers.h"
#include "base/yaml/setting.h"
#include "base/yaml/write.h"

namespace tread {

template struct detail::FieldsOf<VehicleParams>;
template struct detail::FieldsOf<InertiaParams>;
template struct detail::FieldsOf<LoadParams>;
template struct detail::FieldsOf<AxleParams>;
template struct detail::FieldsOf<TyreParams>;
template struct detail::FieldsOf<SteeringParams>;
template struct detail::FieldsOf<DrivelineParams>;
template struct detail::FieldsOf<BrakeParams>;
template struct detail::FieldsOf<AeroParams>;

}  // namespace tread
