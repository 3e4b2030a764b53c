// MATLAB files (.mat, versions 4, 5 and, as far as matio was built with HDF5, 7.3): every real numeric array becomes
// one column or, when it has several, one for each of its columns; fields of structs are named with dots.
#include <algorithm>
#include <memory>

#include "import/formats/foreign_table.h"
#include "import/formats/mat_library.h"
#include "import/formats/mat_whole.h"
#include "log/csv.h"

namespace tread {
namespace {

constexpr std::size_t kLargestMat = std::size_t{2} << 30;  // bytes of one array
constexpr std::size_t kMostColumns = 20000;                // of a file
constexpr int kDeepest = 16;                               // structs in structs

double element(const matvar_t& variable, std::size_t i) {
    const auto at = [&]<class T>(T) { return static_cast<double>(static_cast<const T*>(variable.data)[i]); };
    switch (variable.data_type) {
        case MAT_T_DOUBLE:
            return at(double{});
        case MAT_T_SINGLE:
            return at(float{});
        case MAT_T_INT8:
            return at(mat_int8_t{});
        case MAT_T_UINT8:
            return at(mat_uint8_t{});
        case MAT_T_INT16:
            return at(mat_int16_t{});
        case MAT_T_UINT16:
            return at(mat_uint16_t{});
        case MAT_T_INT32:
            return at(mat_int32_t{});
        case MAT_T_UINT32:
            return at(mat_uint32_t{});
        case MAT_T_INT64:
            return at(mat_int64_t{});
        case MAT_T_UINT64:
            return at(mat_uint64_t{});
        default:
            return std::numeric_limits<double>::quiet_NaN();
    }
}

bool isNumeric(const matvar_t& variable) {
    return variable.class_type >= MAT_C_DOUBLE && variable.class_type <= MAT_C_UINT64 && !variable.isComplex;
}

class Flatten {
public:
    Flatten(const MatLibrary& matio, ForeignTable& table) : matio_(matio), table_(table) {}

    void take(matvar_t* variable, const std::string& name, int depth = 0) {
        if (!variable || depth > kDeepest || table_.columns.size() > kMostColumns) return;
        if (variable->class_type == MAT_C_STRUCT) {
            takeStruct(*variable, name, depth);
        } else if (isNumeric(*variable) && variable->data && variable->rank == 2) {
            takeArray(*variable, name);
        } else if (variable->class_type != MAT_C_CHAR && variable->class_type != MAT_C_EMPTY) {
            passOver(name);
        }
    }

    void passOver(const std::string& name) {
        ++passed_over_;
        if (first_.empty()) first_ = name;
    }

    void finish() {
        if (passed_over_ == 0) return;
        table_.notes.push_back(std::to_string(passed_over_) + " variable" + (passed_over_ == 1 ? "" : "s") +
                               " that tread cannot read (objects, tables, cells, complex numbers" +
                               (first_.empty() ? "" : ": " + first_) + ")" +
                               (passed_over_ == 1 ? " was" : " were") + " skipped");
    }

private:
    void takeStruct(matvar_t& variable, const std::string& name, int depth) {
        std::size_t elements = 1;
        for (int i = 0; i < variable.rank; ++i) elements *= variable.dims[i];
        const unsigned fields = matio_.varGetNumberOfFields(&variable);
        char* const* const names = matio_.varGetStructFieldnames(&variable);
        for (std::size_t e = 0; e < elements && names; ++e) {
            const std::string index = elements == 1 ? "" : "(" + std::to_string(e + 1) + ")";
            for (unsigned f = 0; f < fields; ++f) {
                take(matio_.varGetStructFieldByIndex(&variable, f, e), name + index + "." + names[f], depth + 1);
            }
        }
    }

    void takeArray(const matvar_t& variable, const std::string& name) {
        std::size_t rows = variable.dims[0], columns = variable.dims[1];
        if (rows * columns > variable.nbytes / std::max(variable.data_size, 1)) return;  // a header that promises more
        if (rows == 1) std::swap(rows, columns);                                         // a row vector is one channel
        for (std::size_t c = 0; c < columns && table_.columns.size() <= kMostColumns; ++c) {
            ForeignColumn column;
            column.name = columns == 1 ? name : name + "(:," + std::to_string(c + 1) + ")";
            column.values.reserve(rows);
            for (std::size_t r = 0; r < rows; ++r) column.values.push_back(element(variable, c * rows + r));
            table_.columns.push_back(std::move(column));
        }
    }

    const MatLibrary& matio_;
    ForeignTable& table_;
    std::size_t passed_over_ = 0;
    std::string first_;
};

}  // namespace

ForeignTable readMat(const std::filesystem::path& path) {
    const std::string file = path.string();
    ForeignTable table{file, "MATLAB file", {}, {}, {}};
    const MatContents contents = matContents(readBytes(path));
    if (!contents.fault.empty()) throw LoadError({{file, 0, 0, "", contents.fault}});
    const MatLibrary& matio = matLibrary(file);
    const std::unique_ptr<mat_t, decltype(matio.close)> mat(matio.open(file.c_str(), MAT_ACC_RDONLY), matio.close);
    if (!mat)
        throw LoadError(
            {{file, 0, 0, "", "is not a MATLAB file that can be read, or one of version 7.3 that is cut off"}});

    Flatten flatten(matio, table);
    std::size_t variables = 0;
    while (const auto info =
               std::unique_ptr<matvar_t, decltype(matio.varFree)>(matio.varReadNextInfo(mat.get()), matio.varFree)) {
        ++variables;
        const std::string name = info->name ? info->name : "";
        if (name.empty()) {  // an object, whose name matio does not tell, or the array with the parts of all objects
            if (info->class_type == MAT_C_OPAQUE) flatten.passOver(name);
            continue;
        }
        std::size_t elements = 1;
        for (int i = 0; i < info->rank; ++i) elements *= std::max<std::size_t>(info->dims[i], 1);
        if (elements > kLargestMat / sizeof(double)) {
            throw LoadError({{file, 0, 0, name, "claims " + std::to_string(elements) + " values, more than 2 GB"}});
        }
        const bool needed = info->class_type == MAT_C_STRUCT || isNumeric(*info);
        if (needed && matio.varReadDataAll(mat.get(), info.get()) != 0) {
            throw LoadError({{file, 0, 0, name, "could not be read; the file is cut off or damaged there"}});
        }
        flatten.take(info.get(), name);
    }
    flatten.finish();
    if (variables < contents.variables) {
        table.notes.push_back("variable number " + std::to_string(variables + 1) + " of " +
                              std::to_string(contents.variables) +
                              " is of a kind that the MATLAB library cannot read; it and those after it were skipped");
    }
    if (table.columns.empty()) {
        throw LoadError({{file, 0, 0, "",
                          "holds no real numeric array, expected one variable (or field of a struct) per channel" +
                              std::string(table.notes.empty() ? "" : "; " + table.notes.front())}});
    }
    return table;
}

}  // namespace tread
