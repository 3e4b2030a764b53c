// The known manoeuvres, each in a file of its name.
#pragma once

#include "metrics/metrics.h"

namespace tread {

Manoeuvre dropAndSettle();
Manoeuvre parked();
Manoeuvre straightBraking();
Manoeuvre coastDown();
Manoeuvre fishhook();
Manoeuvre jTurn();
Manoeuvre stepSteer();
Manoeuvre sineSteer();
Manoeuvre frequencyResponse();
Manoeuvre slowlyIncreasingSteer();
Manoeuvre sineWithDwell();
Manoeuvre splitMuBraking();
Manoeuvre brakingInTurn();
Manoeuvre powerOff();
Manoeuvre acceleration();
Manoeuvre freeSteer();
Manoeuvre weave();
Manoeuvre transition();
Manoeuvre hillStart();
Manoeuvre laneChange();
Manoeuvre course();
Manoeuvre crosswind();
Manoeuvre steadyCircle();
Manoeuvre bump();
Manoeuvre ride();
Manoeuvre straightRunning();

}  // namespace tread
