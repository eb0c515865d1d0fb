'use strict';
// node sprite_readers.cjs MODULES ARRAY.json HASH.json: reads sheets by the parsers of Phaser and Pixi, and holds what they
// find against each other.
const assert = require('assert');
const fs = require('fs');
const path = require('path');
const [modules, arrayFile, hashFile] = process.argv.slice(2);
const sheetOf = (file) => JSON.parse(fs.readFileSync(file, 'utf8'));
const fromModules = (name) => require(path.resolve(modules, name));

const JSONArray = fromModules('phaser/src/textures/parsers/JSONArray.js');
const JSONHash = fromModules('phaser/src/textures/parsers/JSONHash.js');
const AnimationManager = fromModules('phaser/src/animations/AnimationManager.js');
const { Spritesheet } = fromModules('pixi.js/lib/spritesheet/Spritesheet.js');
const { Texture } = fromModules('pixi.js/lib/rendering/renderers/shared/texture/Texture.js');
const { TextureSource } = fromModules('pixi.js/lib/rendering/renderers/shared/texture/sources/TextureSource.js');

/// Frames that a parser of Phaser adds to a texture.
function phaserFrames(parser, json) {
    const frames = {};
    const size = json.meta.size;
    parser({
        source: [{ width: size.w, height: size.h }],
        customData: {},
        add(name, source, x, y, w, h) {
            assert(!(name in frames), `two frames are called ${name}`);
            frames[name] = { x, y, w, h, setTrim(...trim) { this.trim = trim; } };
            return frames[name];
        },
    }, 0, json);
    delete frames.__BASE;
    return frames;
}

const array = sheetOf(arrayFile), hash = sheetOf(hashFile);
const count = array.frames.length;
const plain = phaserFrames(JSONArray, array), named = phaserFrames(JSONHash, hash);
assert.strictEqual(Object.keys(plain).length, count);
assert.strictEqual(Object.keys(named).length, count);

// Phaser makes an animation of each tag, whose frames its texture has.
const made = [];
const manager = Object.create(AnimationManager.prototype);
manager.game = { cache: { json: { get: () => array } } };
manager.create = (animation) => made.push(animation);
manager.createFromAseprite('sheet');
assert.strictEqual(made.length, array.meta.frameTags.length);
assert.strictEqual(made.reduce((sum, each) => sum + each.frames.length, 0), count);
for (const animation of made) {
    assert(animation.duration > 0);
    for (const frame of animation.frames) assert(frame.frame in plain, frame.frame);
}

// Pixi finds the same animations, and each frame in the same place.
const source = new TextureSource({ width: hash.meta.size.w, height: hash.meta.size.h });
const sheet = new Spritesheet(new Texture({ source }), hash);
sheet.parse().then(() => {
    const names = made.map((animation) => animation.key);
    assert.deepStrictEqual(Object.keys(sheet.animations), names);
    for (const animation of made)
        animation.frames.forEach(({ frame }, i) => {
            const texture = sheet.animations[animation.key][i], other = plain[frame];
            assert(texture, `${animation.key} has no frame ${i}`);
            assert.deepStrictEqual([texture.frame.x, texture.frame.y, texture.frame.width, texture.frame.height],
                                   [other.x, other.y, other.w, other.h]);
            assert.deepStrictEqual([texture.orig.width, texture.orig.height],
                                   [array.frames[frame].sourceSize.w, array.frames[frame].sourceSize.h]);
            if (other.trim) assert.deepStrictEqual([texture.trim.x, texture.trim.y], other.trim.slice(2, 4));
            const pivot = array.meta.slices[0].keys[Number(frame)].pivot;
            assert(Math.abs(texture.defaultAnchor.x * texture.orig.width - pivot.x) < 1e-9);
            assert(Math.abs(texture.defaultAnchor.y * texture.orig.height - pivot.y) < 1e-9);
        });
    console.log(`${count} frames in ${names.length} animations: ${names.join(', ')}`);
});
