// The visitors of the fields of a car and of its parts, instantiated once.
#pragma once

#include "base/fields/visitors.h"
#include "tread/vehicle.h"

namespace tread {

extern template struct detail::FieldsOf<VehicleParams>;
extern template struct detail::FieldsOf<InertiaParams>;
extern template struct detail::FieldsOf<LoadParams>;
extern template struct detail::FieldsOf<AxleParams>;
extern template struct detail::FieldsOf<TyreParams>;
extern template struct detail::FieldsOf<SteeringParams>;
extern template struct detail::FieldsOf<DrivelineParams>;
extern template struct detail::FieldsOf<BrakeParams>;
extern template struct detail::FieldsOf<AeroParams>;

}  // namespace tread
