#include "import/formats/mat_library.h"

#include <dlfcn.h>

#include "tread/problem.h"

namespace tread {
namespace {

[[noreturn]] void fail(const std::string& file) {
    const char* const reason = dlerror();
    throw LoadError({{file, 0, 0, "",
                      std::string("is a MATLAB file, and matio, the library that reads it, cannot be loaded (") +
                          (reason ? reason : "no reason is given") + "); install matio"}});
}

MatLibrary load(const std::string& file) {
    void* const library = dlopen(TREAD_MATIO, RTLD_NOW | RTLD_LOCAL);
    if (!library) fail(file);
    const auto find = [&]<class F>(F& function, const char* name) {
        function = reinterpret_cast<F>(dlsym(library, name));
        if (!function) fail(file);
    };
    MatLibrary matio;
    find(matio.logInitFunc, "Mat_LogInitFunc");
    find(matio.open, "Mat_Open");
    find(matio.close, "Mat_Close");
    find(matio.varReadNextInfo, "Mat_VarReadNextInfo");
    find(matio.varReadDataAll, "Mat_VarReadDataAll");
    find(matio.varFree, "Mat_VarFree");
    find(matio.varGetNumberOfFields, "Mat_VarGetNumberOfFields");
    find(matio.varGetStructFieldnames, "Mat_VarGetStructFieldnames");
    find(matio.varGetStructFieldByIndex, "Mat_VarGetStructFieldByIndex");
    matio.logInitFunc("tread", [](int, char*) {});  // its words would stand between ours
    return matio;
}

}  // namespace

const MatLibrary& matLibrary(const std::string& file) {
    static const MatLibrary library = load(file);
    return library;
}

}  // namespace tread
