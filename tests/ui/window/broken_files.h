#pragma once

#include "render/files/assets.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QStringList>

namespace vitrine::test {

inline QByteArray bytesIn(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Returns the bytes of a shipped glTF model.
inline QByteArray goodModel()
{
    return bytesIn(QString::fromStdString(render::asset("models/teddy.glb").string()));
}

/// Converts apostrophes to quotes.
inline QByteArray withQuotes(QByteArray text)
{
    return text.replace('\'', '"');
}

/// Returns a binary glTF file with this JSON and no further chunk.
inline QByteArray glbOf(QByteArray json)
{
    while (json.size() % 4 != 0) json += ' ';
    const auto word = [](qsizetype n) {
        const auto x = static_cast<quint32>(n);
        return QByteArray(reinterpret_cast<const char*>(&x), 4);
    };
    return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
}

/// Writes files of which each once crashed the program. Returns their paths.
inline QStringList writeBrokenFiles(const QDir& folder)
{
    const auto path = [&folder](const char* name) { return folder.filePath(QString::fromUtf8(name)); };
    const auto write = [&path](const char* name, const QByteArray& bytes) {
        QFile file(path(name));
        if (file.open(QIODevice::WriteOnly)) file.write(bytes);
    };
    write("draco.glb",
          glbOf(withQuotes(
              "{'asset':{'version':'2.0'},'extensionsUsed':['KHR_draco_mesh_compression'],'extensionsRequired'"
              ":['KHR_draco_mesh_compression'],'scene':0,'scenes':[{'nodes':[]}]}")));
    write("truncated.glb", goodModel().left(5000));
    QByteArray noise;
    for (int i = 0; i < 4000; ++i) noise += static_cast<char>((i * 7919 + i / 13) & 255);
    write("noise.glb", noise);
    write(
        "no-bin.gltf",
        withQuotes("{'asset':{'version':'2.0'},'scene':0,'scenes':[{'nodes':[0]}],'nodes':[{'mesh':0}],'meshes':[{'"
                   "primitives':[{'attributes':{'POSITION':0}}]}],"
                   "'accessors':[{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3','min':[0,0,0],'max':[1,1,"
                   "1]}],"
                   "'bufferViews':[{'buffer':0,'byteLength':36}],'buffers':[{'byteLength':36,'uri':'no-bin.bin'}]}"));
    write("truncated.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n\x02\x02");
    QImage picture(256, 128, QImage::Format_RGB32);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 256; ++x) picture.setPixel(x, y, qRgb(x, 2 * y, x ^ y));
    picture.save(path("whole.jpg"), "JPG", 95);
    write("truncated.jpg", bytesIn(path("whole.jpg")).left(3000));
    return {path("draco.glb"),   path("truncated.glb"), path("noise.glb"),
            path("no-bin.gltf"), path("truncated.hdr"), path("truncated.jpg")};
}

}  // namespace vitrine::test
