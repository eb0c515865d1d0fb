#pragma once

#include <QObject>
#include <QString>

#include <cstddef>
#include <future>

namespace vitrine::ui {

class Workbench;

/// Writes the shader of an exhibit that can stand alone into a file of the visitor's, and shows it as the visitor's own
/// shader.
class ShaderCopy final : public QObject {
    Q_OBJECT

public:
    /// The window must outlive this object.
    explicit ShaderCopy(Workbench&, QObject* parent = nullptr);
    /// Waits for the end of writing.
    ~ShaderCopy() override;

    /// Asks for a file, and copies the shader of this exhibit into it.
    void ask(std::size_t exhibit);
    /// Copies the shader of this exhibit, with its present values, into a file on a thread of its own. Then the exhibit
    /// that shows visitors' shaders is visited and shows it. An error is reported, and nothing changes.
    void copyTo(std::size_t exhibit, const QString& path);

signals:
    /// Emitted when the file is shown.
    void copied(const QString& path);

private:
    void show(const QString& path, const QString& notes);

    Workbench& window_;
    std::future<void> writing_;
};

}  // namespace vitrine::ui
