#include "recording/subject.h"

#include "base/fields/numbers.h"

namespace tread::recording {

double* numberAt(Subject& subject, std::string_view path) {
    for (const Number& number : numbers(subject)) {
        if (number.path == path) return number.value;
    }
    return nullptr;
}

}  // namespace tread::recording

template void tread::detail::FieldsOf<tread::recording::Subject>::addNumbers(tread::recording::Subject&,
                                                                             const std::string&,
                                                                             std::vector<tread::Number>&);
