// Many diagnoses with one table over all.
#pragma once

#include "commands.h"
#include "diagnose/answer/diagnosis.h"
#include "diagnose/options.h"
#include "diagnose_check.h"

namespace tread::program {

// Diagnoses, and writes all results into the folder. Throws SimulationError, FileError.
diagnose::answer::Diagnosis diagnoseInto(const DiagnosisInputs& inputs, const Path& out,
                                         tread::diagnose::Options options);

// Diagnoses each diagnosis.yaml in the folders of `request.all`, beside other processes that do the same. Each has a
// folder of results of its own name; once all are there, diagnoses.csv and index.html hold one row for each.
int diagnoseAll(const DiagnoseRequest& request);

}  // namespace tread::program
