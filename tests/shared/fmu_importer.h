// An FMU as a master sees it: unpacked, its description read, its shared object opened, its cars stepped. For both
// versions of FMI.
#pragma once

#include <dlfcn.h>
#include <zip.h>

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "fmu/object/fmi2.h"
#include "fmu/object/fmi3.h"
#include "shared/markup.h"
#include "shared/scratch.h"

namespace tread::shared {

// Names and contents of the files of an archive.
inline std::map<std::string, std::string> unzipped(const std::string& file) {
    int fault = 0;
    zip_t* archive = zip_open(file.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &fault);
    if (!archive) throw std::runtime_error("no zip file: " + file);
    std::map<std::string, std::string> files;
    for (zip_int64_t i = 0; i < zip_get_num_entries(archive, 0); ++i) {
        zip_stat_t about;
        zip_stat_index(archive, static_cast<zip_uint64_t>(i), 0, &about);
        zip_file_t* entry = zip_fopen_index(archive, static_cast<zip_uint64_t>(i), 0);
        std::string content(about.size, '\0');
        if (zip_fread(entry, content.data(), about.size) != static_cast<zip_int64_t>(about.size))
            throw std::runtime_error("cannot read " + std::string(about.name));
        zip_fclose(entry);
        files[about.name] = content;
    }
    zip_discard(archive);
    return files;
}

// The tags of an XML file, in order.
inline std::vector<Tag> tagsOf(const std::string& xml) {
    std::vector<Tag> tags;
    for (std::size_t at = xml.find('<', xml.find("?>")); at < xml.size(); at = xml.find('<', at)) {
        const std::string rest = xml.substr(at, 40);
        const auto tag = readTag(xml, at);
        if (!tag) throw std::runtime_error("no tag: " + rest);
        tags.push_back(*tag);
    }
    return tags;
}

// The C++ library within an FMU keeps memory for exceptions, a leak once nothing refers to it any more.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr int kHowToLoad = RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE;
#else
inline constexpr int kHowToLoad = RTLD_NOW | RTLD_LOCAL;
#endif

// Unpacked in a folder of its own.
class Fmu {
public:
    explicit Fmu(const std::string& file) : files(unzipped(file)), tags(tagsOf(files.at("modelDescription.xml"))) {
        for (const auto& [name, content] : files) {
            std::filesystem::create_directories(std::filesystem::path(scratch_.path(name)).parent_path());
            scratch_.file(name, content);
        }
        const bool fmi3 = tags.front().attributes.at("fmiversion") == "3.0";
        token = tags.front().attributes.at(fmi3 ? "instantiationtoken" : "guid");
        resources = fmi3 ? scratch_.path("resources/") : "file://" + scratch_.path("resources");
        object_ = dlopen(scratch_.path(fmi3 ? "binaries/x86_64-linux/tread.so" : "binaries/linux64/tread.so").c_str(),
                         kHowToLoad);
        if (!object_) throw std::runtime_error(dlerror());
        for (const Tag& tag : tags) {
            if (!tag.attributes.contains("valuereference") || !tag.attributes.contains("name")) continue;
            references_[tag.attributes.at("name")] =
                static_cast<unsigned>(std::stoul(tag.attributes.at("valuereference")));
        }
    }
    ~Fmu() { dlclose(object_); }
    Fmu(const Fmu&) = delete;
    Fmu& operator=(const Fmu&) = delete;

    unsigned reference(const std::string& name) const { return references_.at(name); }
    template <class Function>
    Function* function(const char* name) const {
        void* found = dlsym(object_, name);
        if (!found) throw std::runtime_error(std::string("no function ") + name);
        return reinterpret_cast<Function*>(found);
    }

    const std::map<std::string, std::string> files;
    const std::vector<Tag> tags;
    std::string token, resources;

private:
    Scratch scratch_;
    void* object_ = nullptr;
    std::map<std::string, unsigned> references_;
};

// One car of an FMU. What fails throws what the FMU has said.
class FmuCar {
public:
    virtual ~FmuCar() = default;
    virtual void start(const std::map<std::string, double>& numbers, const std::map<std::string, bool>& flags) = 0;
    virtual void setAll(const std::vector<unsigned>& references, const std::vector<double>& values) = 0;
    virtual std::vector<double> getAll(const std::vector<unsigned>& references) = 0;
    virtual void step(double time, double duration) = 0;
    virtual void* save() = 0;
    virtual void restore(void* state) = 0;
    virtual void release(void* state) = 0;
    virtual std::string serialise(void* state) = 0;
    virtual void* deserialise(const std::string& bytes) = 0;
    virtual void reset() = 0;

    double get(const std::string& name) { return getAll(std::vector{fmu_.reference(name)}).front(); }
    void set(const std::string& name, double value) { setAll({fmu_.reference(name)}, {value}); }

protected:
    explicit FmuCar(const Fmu& fmu) : fmu_(fmu) {}
    FmuCar(const FmuCar&) = delete;
    FmuCar& operator=(const FmuCar&) = delete;
    void demand(int status) const {
        if (status != 0) throw std::runtime_error(said_.empty() ? "no reason said" : said_);
    }
    template <class Call>
    auto call(const char* name) const {
        return fmu_.function<Call>(name);
    }

    const Fmu& fmu_;
    std::string said_;
};

#define TREAD_CALL(name) call<decltype(name)>(#name)

class Fmi2Car final : public FmuCar {
public:
    explicit Fmi2Car(const Fmu& fmu, const std::string& token = {}) : FmuCar(fmu) {
        const fmi2CallbackFunctions callbacks{log, nullptr, nullptr, nullptr, &said_};
        car_ = TREAD_CALL(fmi2Instantiate)("car", fmi2CoSimulation, (token.empty() ? fmu.token : token).c_str(),
                                           fmu.resources.c_str(), &callbacks, 0, 0);
        demand(car_ ? 0 : 3);
    }
    ~Fmi2Car() override { TREAD_CALL(fmi2FreeInstance)(car_); }

    void start(const std::map<std::string, double>& numbers, const std::map<std::string, bool>& flags) override {
        demand(TREAD_CALL(fmi2SetupExperiment)(car_, 0, 0, 0, 0, 0));
        for (const auto& [name, value] : numbers) set(name, value);
        for (const auto& [name, value] : flags) {
            const unsigned reference = fmu_.reference(name);
            const int flag = value;
            demand(TREAD_CALL(fmi2SetBoolean)(car_, &reference, 1, &flag));
        }
        demand(TREAD_CALL(fmi2EnterInitializationMode)(car_));
        demand(TREAD_CALL(fmi2ExitInitializationMode)(car_));
    }
    void setAll(const std::vector<unsigned>& references, const std::vector<double>& values) override {
        demand(TREAD_CALL(fmi2SetReal)(car_, references.data(), values.size(), values.data()));
    }
    std::vector<double> getAll(const std::vector<unsigned>& references) override {
        std::vector<double> values(references.size());
        demand(TREAD_CALL(fmi2GetReal)(car_, references.data(), values.size(), values.data()));
        return values;
    }
    void step(double time, double duration) override { demand(TREAD_CALL(fmi2DoStep)(car_, time, duration, 1)); }
    void* save() override {
        void* state = nullptr;
        demand(TREAD_CALL(fmi2GetFMUstate)(car_, &state));
        return state;
    }
    void restore(void* state) override { demand(TREAD_CALL(fmi2SetFMUstate)(car_, state)); }
    void release(void* state) override { demand(TREAD_CALL(fmi2FreeFMUstate)(car_, &state)); }
    std::string serialise(void* state) override {
        std::size_t size = 0;
        demand(TREAD_CALL(fmi2SerializedFMUstateSize)(car_, state, &size));
        std::string bytes(size, '\0');
        demand(TREAD_CALL(fmi2SerializeFMUstate)(car_, state, bytes.data(), size));
        return bytes;
    }
    void* deserialise(const std::string& bytes) override {
        void* state = nullptr;
        demand(TREAD_CALL(fmi2DeSerializeFMUstate)(car_, bytes.data(), bytes.size(), &state));
        return state;
    }
    void reset() override { demand(TREAD_CALL(fmi2Reset)(car_)); }

private:
    static void log(fmi2ComponentEnvironment said, fmi2String, fmi2Status, fmi2String, fmi2String format, ...) {
        std::array<char, 2000> text{};
        va_list words;
        va_start(words, format);
        std::vsnprintf(text.data(), text.size(), format, words);
        va_end(words);
        *static_cast<std::string*>(said) = text.data();
    }

    fmi2Component car_ = nullptr;
};

class Fmi3Car final : public FmuCar {
public:
    explicit Fmi3Car(const Fmu& fmu, const std::string& token = {}) : FmuCar(fmu) {
        car_ = TREAD_CALL(fmi3InstantiateCoSimulation)("car", (token.empty() ? fmu.token : token).c_str(),
                                                       fmu.resources.c_str(), false, false, false, false, nullptr, 0,
                                                       &said_, log, nullptr);
        demand(car_ ? 0 : 3);
    }
    ~Fmi3Car() override { TREAD_CALL(fmi3FreeInstance)(car_); }

    void start(const std::map<std::string, double>& numbers, const std::map<std::string, bool>& flags) override {
        for (const auto& [name, value] : numbers) set(name, value);
        for (const auto& [name, value] : flags) {
            const unsigned reference = fmu_.reference(name);
            demand(TREAD_CALL(fmi3SetBoolean)(car_, &reference, 1, &value, 1));
        }
        demand(TREAD_CALL(fmi3EnterInitializationMode)(car_, false, 0, 0, false, 0));
        demand(TREAD_CALL(fmi3ExitInitializationMode)(car_));
    }
    void setAll(const std::vector<unsigned>& references, const std::vector<double>& values) override {
        demand(TREAD_CALL(fmi3SetFloat64)(car_, references.data(), values.size(), values.data(), values.size()));
    }
    std::vector<double> getAll(const std::vector<unsigned>& references) override {
        std::vector<double> values(references.size());
        demand(TREAD_CALL(fmi3GetFloat64)(car_, references.data(), values.size(), values.data(), values.size()));
        return values;
    }
    void step(double time, double duration) override {
        bool event = true, terminate = true, early = true;
        double last = 0;
        demand(TREAD_CALL(fmi3DoStep)(car_, time, duration, true, &event, &terminate, &early, &last));
        if (event || terminate || early || std::abs(last - time - duration) > 1e-9)
            throw std::runtime_error("a step that was not made in full");
    }
    void* save() override {
        void* state = nullptr;
        demand(TREAD_CALL(fmi3GetFMUState)(car_, &state));
        return state;
    }
    void restore(void* state) override { demand(TREAD_CALL(fmi3SetFMUState)(car_, state)); }
    void release(void* state) override { demand(TREAD_CALL(fmi3FreeFMUState)(car_, &state)); }
    std::string serialise(void* state) override {
        std::size_t size = 0;
        demand(TREAD_CALL(fmi3SerializedFMUStateSize)(car_, state, &size));
        std::vector<fmi3Byte> bytes(size);
        demand(TREAD_CALL(fmi3SerializeFMUState)(car_, state, bytes.data(), size));
        return {bytes.begin(), bytes.end()};
    }
    void* deserialise(const std::string& text) override {
        const std::vector<fmi3Byte> bytes(text.begin(), text.end());
        void* state = nullptr;
        demand(TREAD_CALL(fmi3DeserializeFMUState)(car_, bytes.data(), bytes.size(), &state));
        return state;
    }
    void reset() override { demand(TREAD_CALL(fmi3Reset)(car_)); }

private:
    static void log(fmi3InstanceEnvironment said, fmi3Status, fmi3String, fmi3String message) {
        *static_cast<std::string*>(said) = message;
    }

    fmi3Instance car_ = nullptr;
};

#undef TREAD_CALL

inline std::unique_ptr<FmuCar> carOf(const Fmu& fmu, const std::string& token = {}) {
    const bool fmi3 = fmu.tags.front().attributes.at("fmiversion") == "3.0";
    if (fmi3) return std::make_unique<Fmi3Car>(fmu, token);
    return std::make_unique<Fmi2Car>(fmu, token);
}

}  // namespace tread::shared
