#include "exhibits/printing/view_sequence.h"

#include "exhibits/printing/print_layout.h"
#include "render/failure.h"

#include <string>

namespace vitrine::lenticular {

std::vector<std::size_t> chosenViews(std::size_t available, const SequenceSettings& settings)
{
    if (settings.every < 1) throw Failure(Blame::usage, "--every " + std::to_string(settings.every) + ": give 1 or more.");
    std::vector<std::size_t> row;
    for (std::size_t i = 0; i < available; i += static_cast<std::size_t>(settings.every)) row.push_back(i);
    if (row.empty()) throw Failure(Blame::usage, "There are no views; give pictures with --views or --quilt, or an --exhibit.");
    if (settings.pingPong)
        for (std::size_t i = row.size() - 1; i-- > 1;) row.push_back(row[i]);

    if (settings.count < 0 || static_cast<std::size_t>(settings.count) > row.size()) {
        throw Failure(Blame::usage, "--count " + std::to_string(settings.count) + ": there are " + std::to_string(row.size()) + " views; give 1 to " + std::to_string(row.size()) + ", or leave it out for all.");
    }
    const auto most = static_cast<std::size_t>(mostViews);
    const std::size_t count = settings.count == 0 ? row.size() : static_cast<std::size_t>(settings.count);
    if (count > most) {
        throw Failure(Blame::usage, "There are " + std::to_string(count) + " views, and " + std::to_string(mostViews) + " is the most; take fewer with --every " +
                                        std::to_string((row.size() + most - 1) / most * static_cast<std::size_t>(settings.every)) + " or --count " + std::to_string(mostViews) + ".");
    }
    std::vector<std::size_t> chosen;
    const std::size_t last = row.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        // The nearest to an even spread; one view alone is the middle one.
        chosen.push_back(row[count == 1 ? (last + 1) / 2 : (2 * last * i + count - 1) / (2 * (count - 1))]);
    }
    return chosen;
}

}  // namespace vitrine::lenticular
