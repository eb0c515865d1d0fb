#include "render/gl/uploads.h"

#include "render/failure.h"

namespace vitrine::render::gl {
namespace {

TextureName bufferTexture(const UploadedBytes& uploaded, Texels type)
{
    constexpr std::int64_t texelBytes = 16;
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (uploaded.bytes / texelBytes > most)
        throw Failure(
            ErrorKind::openGl,
            message("Cannot draw: the shapes take {1} texels, more than the {2} that this driver reads from a "
                    "buffer; show a scene of fewer shapes.",
                    uploaded.bytes / texelBytes, most));
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_BUFFER, 1, &name);
    glTextureBuffer(name, type == Texels::vec4 ? GL_RGBA32F : GL_RGBA32UI, uploaded.buffer.name());
    return TextureName(name);
}

}  // namespace

UploadedBytes::UploadedBytes(const Bytes& source) : bytes(static_cast<std::int64_t>(source.size()))
{
    GLuint name = 0;
    glCreateBuffers(1, &name);
    buffer = BufferName(name);
    // A buffer of 0 bytes cannot be bound.
    if (source.empty())
        glNamedBufferStorage(name, 16, nullptr, 0);
    else
        glNamedBufferStorage(name, static_cast<GLsizeiptr>(source.size()), source.data(), 0);
}

const Texture& Uploads::texture(const std::shared_ptr<const render::Texture>& picture)
{
    auto found = textures_.find(picture.get());
    if (found == textures_.end() || found->second.source.expired())
        found =
            textures_.insert_or_assign(picture.get(), Uploaded<render::Texture, Texture>{picture, Texture(*picture)})
                .first;
    return found->second.buffers;
}

const MeshBuffers& Uploads::mesh(const std::shared_ptr<const Mesh>& mesh)
{
    auto found = meshes_.find(mesh.get());
    if (found == meshes_.end() || found->second.source.expired())
        found = meshes_.insert_or_assign(mesh.get(), Uploaded<Mesh, MeshBuffers>{mesh, MeshBuffers(*mesh)}).first;
    return found->second.buffers;
}

const UploadedBytes& Uploads::bytes(const std::shared_ptr<const Bytes>& source)
{
    auto found = bytes_.find(source.get());
    if (found == bytes_.end() || found->second.source.expired())
        found =
            bytes_.insert_or_assign(source.get(), Uploaded<Bytes, UploadedBytes>{source, UploadedBytes(*source)}).first;
    return found->second.buffers;
}

GLuint Uploads::texels(const std::shared_ptr<const Bytes>& source, Texels type)
{
    (void)bytes(source);
    UploadedBytes& uploaded = bytes_.at(source.get()).buffers;
    if (uploaded.texels.name() == 0) uploaded.texels = bufferTexture(uploaded, type);
    return uploaded.texels.name();
}

void Uploads::sweep()
{
    std::erase_if(bytes_, [](const auto& entry) { return entry.second.source.expired(); });
    std::erase_if(textures_, [](const auto& entry) { return entry.second.source.expired(); });
    std::erase_if(meshes_, [](const auto& entry) { return entry.second.source.expired(); });
}

std::vector<Stored> Uploads::stored() const
{
    Stored pictures{"pictures"};
    Stored meshes{"meshes"};
    for (const auto& [key, uploaded] : textures_) pictures.add(uploaded.buffers.bytes());
    for (const auto& [key, uploaded] : meshes_) meshes.add(uploaded.buffers.bytes());
    Stored constants{"constant buffers"};
    for (const auto& [key, uploaded] : bytes_) constants.add(uploaded.buffers.bytes);
    return {pictures, meshes, constants};
}

void Uploads::abandon()
{
    for (auto& [key, uploaded] : textures_) uploaded.buffers.abandon();
    for (auto& [key, uploaded] : meshes_) uploaded.buffers.abandon();
    for (auto& [key, uploaded] : bytes_) {
        uploaded.buffers.buffer.abandon();
        uploaded.buffers.texels.abandon();
    }
}

int liveGlNames()
{
    return TextureName::live() + BufferName::live() + VertexArrayName::live() + FramebufferName::live() +
           QueryName::live() + ProgramName::live() + ShaderName::live();
}

}  // namespace vitrine::render::gl
