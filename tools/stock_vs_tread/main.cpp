// Prints the table of known problems of btRaycastVehicle, stock beside tread; exit status 1 where tread misses what it
// must give.
#include <LinearMath/btScalar.h>

#include <cstdio>

#include "problems.h"

int main() {
    problems::Rows rows;
    problems::standing(rows);
    problems::driving(rows);
    problems::tipping(rows);
    problems::grounds(rows);

    std::printf("Bullet in %s precision\n\n", sizeof(btScalar) == sizeof(float) ? "single" : "double");
    std::printf("| %-84s | %11s | %11s | %-4s |\n", "problem", "stock", "tread", "unit");
    std::printf("|%.86s|------------:|------------:|------|\n",
                "----------------------------------------------------------------------------------------------");
    bool good = true;
    for (const problems::Row& row : rows) {
        const bool met = row.tread >= row.lowest && row.tread <= row.highest;
        good &= met;
        std::printf("| %-84s | %11.4g | %11.4g | %-4s |", row.problem.c_str(), row.stock, row.tread, row.unit.c_str());
        if (met) std::printf("\n");
        else std::printf("  <-- tread must give %g to %g\n", row.lowest, row.highest);
    }
    return good ? 0 : 1;
}
