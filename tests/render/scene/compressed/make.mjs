// Makes the compressed models of this folder, each from the same object: a torus of triangles, and a ribbon that is one
// triangle strip. The plain one is written beside them for comparison.
//   npm install --prefix TEMP @gltf-transform/core@4 @gltf-transform/extensions@4 @gltf-transform/functions@4 draco3dgltf meshoptimizer gltfpack
//   cp make.mjs TEMP && node TEMP/make.mjs tests/render/scene/compressed
import { Document, NodeIO, Logger } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import { reorder, quantize } from '@gltf-transform/functions';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import draco3d from 'draco3dgltf';
import { execFileSync } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const out = process.argv[2];
const here = dirname(fileURLToPath(import.meta.url));

function accessor(document, type, array, name) {
    return document.createAccessor(name).setType(type).setArray(array).setBuffer(document.getRoot().listBuffers()[0]);
}

function torus(document) {
    const around = 24, across = 12, R = 0.5, r = 0.2;
    const position = [], normal = [], uv = [], color = [], indices = [];
    for (let i = 0; i <= around; ++i)
        for (let j = 0; j <= across; ++j) {
            const u = (2 * Math.PI * i) / around, v = (2 * Math.PI * j) / across;
            const n = [Math.cos(u) * Math.cos(v), Math.sin(v), Math.sin(u) * Math.cos(v)];
            position.push(Math.cos(u) * R + r * n[0], r * n[1], Math.sin(u) * R + r * n[2]);
            normal.push(...n);
            uv.push(i / around, j / across);
            color.push(Math.round(255 * (i / around)), Math.round(255 * (j / across)), 128, 255);
            if (i === around || j === across) continue;
            const a = i * (across + 1) + j, b = a + across + 1;
            indices.push(a, a + 1, b, b, a + 1, b + 1);
        }
    return document.createPrimitive()
        .setAttribute('POSITION', accessor(document, 'VEC3', new Float32Array(position)))
        .setAttribute('NORMAL', accessor(document, 'VEC3', new Float32Array(normal)))
        .setAttribute('TEXCOORD_0', accessor(document, 'VEC2', new Float32Array(uv)))
        .setAttribute('COLOR_0', accessor(document, 'VEC4', new Uint8Array(color)).setNormalized(true))
        .setIndices(accessor(document, 'SCALAR', new Uint16Array(indices)));
}

// A wave, one strip from left to right: EXT_meshopt_compression stores its indices in the mode INDICES.
function ribbon(document) {
    const steps = 40, position = [], normal = [], uv = [], indices = [];
    for (let i = 0; i <= steps; ++i) {
        const x = i / steps - 0.5, slope = Math.cos(12 * x), length = Math.hypot(1, slope);
        for (const z of [-0.1, 0.1]) {
            position.push(x, 1 + Math.sin(12 * x) / 12, z);
            normal.push(-slope / length, 1 / length, 0);
            uv.push(x + 0.5, z > 0 ? 1 : 0);
            indices.push(indices.length);
        }
    }
    return document.createPrimitive().setMode(5)
        .setAttribute('POSITION', accessor(document, 'VEC3', new Float32Array(position)))
        .setAttribute('NORMAL', accessor(document, 'VEC3', new Float32Array(normal)))
        .setAttribute('TEXCOORD_0', accessor(document, 'VEC2', new Float32Array(uv)))
        .setIndices(accessor(document, 'SCALAR', new Uint16Array(indices)));
}

function turning(document, node) {
    const times = [0, 0.5, 1, 1.5], turns = [];
    for (const t of times) turns.push(0, Math.sin(t), 0, Math.cos(t));
    const sampler = document.createAnimationSampler()
        .setInput(accessor(document, 'SCALAR', new Float32Array(times)))
        .setOutput(accessor(document, 'VEC4', new Float32Array(turns)));
    const channel = document.createAnimationChannel().setTargetNode(node).setTargetPath('rotation').setSampler(sampler);
    document.createAnimation('turn').addSampler(sampler).addChannel(channel);
}

function model(withRibbon) {
    const document = new Document().setLogger(new Logger(Logger.Verbosity.ERROR));
    document.createBuffer();
    const scene = document.createScene();
    const material = document.createMaterial('clay').setBaseColorFactor([0.8, 0.5, 0.3, 1]).setRoughnessFactor(0.6);
    const node = document.createNode('torus').setMesh(document.createMesh('torus').addPrimitive(torus(document).setMaterial(material)));
    scene.addChild(node.setTranslation([0.25, 0.1, -0.3]));
    if (withRibbon) {
        const strip = document.createMesh('ribbon').addPrimitive(ribbon(document).setMaterial(material));
        scene.addChild(document.createNode('ribbon').setMesh(strip));
    }
    turning(document, node);
    return document;
}

await MeshoptEncoder.ready;
await MeshoptDecoder.ready;
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({
    'draco3d.encoder': await draco3d.createEncoderModule(),
    'draco3d.decoder': await draco3d.createDecoderModule(),
    'meshopt.decoder': MeshoptDecoder,
    'meshopt.encoder': MeshoptEncoder,
});
await io.write(join(out, 'torus.glb'), model(false));
await io.write(join(out, 'torus_ribbon.glb'), model(true));

const { EDGEBREAKER, SEQUENTIAL } = KHRDracoMeshCompression.EncoderMethod;
for (const [name, method] of [['draco_edgebreaker.glb', EDGEBREAKER], ['draco_sequential.glb', SEQUENTIAL]]) {
    const document = model(false);
    document.createExtension(KHRDracoMeshCompression).setRequired(true).setEncoderOptions({
        method,
        quantizationBits: { POSITION: 14, NORMAL: 10, COLOR: 8, TEX_COORD: 12, GENERIC: 12 },
    });
    await io.write(join(out, name), document);
}

const { FILTER, QUANTIZE } = EXTMeshoptCompression.EncoderMethod;
for (const [name, method] of [['meshopt_filter.glb', FILTER], ['meshopt_quantize.glb', QUANTIZE]]) {
    const document = model(true);
    await document.transform(reorder({ encoder: MeshoptEncoder }));
    if (method === QUANTIZE) await document.transform(quantize({ quantizePosition: 14, quantizeNormal: 10 }));
    document.createExtension(EXTMeshoptCompression).setRequired(true).setEncoderOptions({ method });
    await io.write(join(out, name), document);
}

// Positions as integers, and as floating-point numbers, which take the filter EXPONENTIAL.
for (const [name, positions] of [['gltfpack.glb', ['-vp', '14']], ['gltfpack_float.glb', ['-vpf']]])
    execFileSync('node', [join(here, 'node_modules/gltfpack/cli.js'), '-i', join(out, 'torus.glb'), '-o', join(out, name),
                          '-cc', '-kn', '-kv', ...positions], { stdio: 'inherit' });
