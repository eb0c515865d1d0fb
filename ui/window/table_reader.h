#pragma once

#include "exhibits/museum/read_tables.h"

#include <QObject>

#include <memory>
#include <string>
#include <vector>

namespace vitrine::ui {

class Workbench;

/// Reader of files that add parameters: reads files named by values on the render thread, and exchanges the tables in
/// the history. Until then, or if a file cannot be read, the values keep their tables.
class TableReader final : public QObject {
    Q_OBJECT

public:
    explicit TableReader(Workbench&, QObject* parent = nullptr);

    /// Reads the files that the present scene state names, unless they were read before.
    void read();
    /// Reads the files again, because they may have changed.
    void readAgain();

private:
    /// Files of an exhibit, and the table of its values.
    struct Named {
        std::vector<std::string> files;
        std::shared_ptr<const Parameters> table;

        bool operator==(const Named&) const = default;
    };
    [[nodiscard]] std::vector<Named> named() const;
    void take(const TabledSceneState&);

    Workbench& window_;
    std::vector<Named> asked_;  ///< Files and tables that were read last, or are being read.
    bool taking_ = false;       ///< The present change of the history comes from this reader.
};

}  // namespace vitrine::ui
