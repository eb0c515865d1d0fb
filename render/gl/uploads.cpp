#include "render/gl/uploads.h"

namespace vitrine::render::gl {

const Texture& Uploads::texture(const std::shared_ptr<const render::Texture>& picture)
{
    auto found = textures_.find(picture.get());
    if (found == textures_.end() || found->second.source.expired())
        found = textures_.insert_or_assign(picture.get(), Uploaded<render::Texture, Texture>{picture, Texture(*picture)}).first;
    return found->second.buffers;
}

const MeshBuffers& Uploads::mesh(const std::shared_ptr<const Mesh>& mesh)
{
    auto found = meshes_.find(mesh.get());
    if (found == meshes_.end() || found->second.source.expired())
        found = meshes_.insert_or_assign(mesh.get(), Uploaded<Mesh, MeshBuffers>{mesh, MeshBuffers(*mesh)}).first;
    return found->second.buffers;
}

void Uploads::sweep()
{
    std::erase_if(textures_, [](const auto& entry) { return entry.second.source.expired(); });
    std::erase_if(meshes_, [](const auto& entry) { return entry.second.source.expired(); });
}

std::vector<Stored> Uploads::stored() const
{
    Stored pictures{"pictures"};
    Stored meshes{"meshes"};
    for (const auto& [key, uploaded] : textures_) pictures.add(uploaded.buffers.bytes());
    for (const auto& [key, uploaded] : meshes_) meshes.add(uploaded.buffers.bytes());
    return {pictures, meshes};
}

void Uploads::abandon()
{
    for (auto& [key, uploaded] : textures_) uploaded.buffers.abandon();
    for (auto& [key, uploaded] : meshes_) uploaded.buffers.abandon();
}

int liveGlNames()
{
    return TextureName::live() + BufferName::live() + VertexArrayName::live() + FramebufferName::live() + QueryName::live() +
           ProgramName::live() + ShaderName::live();
}

}  // namespace vitrine::render::gl
