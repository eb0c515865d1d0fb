#pragma once

#include "exhibits/museum/read_tables.h"

#include <QObject>

#include <memory>
#include <string>
#include <vector>

namespace vitrine::ui {

class Workbench;

/// Where a value names a file that gives its exhibit rows, reads the file on the render thread and exchanges the table
/// in the history. Until then, and where the file cannot be read, the values keep the table that they have.
class TableReader final : public QObject {
    Q_OBJECT

public:
    explicit TableReader(Workbench&, QObject* parent = nullptr);

    /// Reads whatever the look on show names, unless that was read before.
    void read();
    /// The same, whatever was read before: a file may be another one.
    void readAgain();

private:
    /// An exhibit's files and the table that its values have.
    struct Named {
        std::vector<std::string> files;
        std::shared_ptr<const Parameters> table;

        bool operator==(const Named&) const = default;
    };
    [[nodiscard]] std::vector<Named> named() const;
    void take(const TabledSceneState&);

    Workbench& window_;
    std::vector<Named> asked_;  ///< What was read last, or is being read.
    bool taking_ = false;       ///< The history changes because of what was read.
};

}  // namespace vitrine::ui
