// Draws ISF files with vitrine, serves them and the pictures to compare_renderers.html in headless Chromium, which draws them with
// the JavaScript renderer, and prints the differences. Called by compare_renderers.sh.
//   node compare_renderers.mjs FOLDER STEP WORK_FOLDER_WITH_ISF_JS CHROMIUM [FOLDER_FOR_PICTURES]
import {execFileSync, spawn} from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';

const [folder, step, work, chromium, pictures] = process.argv.slice(2);
const here = path.dirname(new URL(import.meta.url).pathname);
const size = {width: 160, height: 120}, moment = 0.05, rate = 60;
const goal = 0.02, share = 0.95;

function vitrine(...words) {
    return execFileSync('build/release/vitrine', words, {encoding: 'utf8', timeout: 120000, stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 28});
}
function draw(file, out, settings) {
    const set = Object.entries({file, moment, rate, ...settings}).flatMap(([name, value]) => ['--set', `your_shader.${name}=${value}`]);
    vitrine('render', 'your_shader', '--alone', ...set, '--set', 'hall.glare=0', '--samples', '1', '--size', `${size.width}x${size.height}`, '--out', out);
}

/// Two pictures for the image inputs, of the size of the drawn ones: the JavaScript renderer divides pixels by that size.
function drawInputs() {
    const shader = path.join(work, 'input.fs');
    fs.writeFileSync(shader, `/*{"ISFVSN": "2", "INPUTS": [{"NAME": "second", "TYPE": "bool"}]}*/
void main() {
    vec2 at = second ? vec2(1.0) - isf_FragNormCoord : isf_FragNormCoord;
    float ring = 0.5 + 0.5 * cos(24.0 * distance(at, vec2(0.4, 0.5)));
    float stripe = mod(6.0 * (at.x + at.y), 2.0) < 1.0 ? 1.0 : 0.7;
    gl_FragColor = vec4(vec3(at.x, second ? 1.0 - ring : ring, at.y) * stripe, 1.0);
}`);
    return ['no', 'yes'].map((second, i) => {
        const out = path.join(work, `input${i}.png`);
        draw(shader, out, {second});
        return out;
    });
}

/// Name of the parameter that an input becomes; `ending` is X, Y or Alpha.
function parameter(parameters, name, ending = '') {
    const camel = name.replace(/_+(.)?/g, (all, next, at) => at ? (next ?? '').toUpperCase() : next ?? '');
    const own = 'own' + camel[0].toUpperCase() + camel.slice(1), lower = camel[0].toLowerCase() + camel.slice(1);
    return [camel, lower, own].map(each => parameters.find(one => one.name.toLowerCase() === (each + ending).toLowerCase())).filter(Boolean).pop();
}

/// Values of ours for the inputs that have no DEFAULT: the JavaScript renderer leaves them at 0, whatever their range is.
function missingValues(inputs, parameters) {
    const values = {};
    for (const {NAME: name, TYPE: type, DEFAULT: initial, VALUES: choices} of inputs) {
        if (initial !== undefined) continue;
        const value = ending => parameter(parameters, name, ending)?.initial;
        if (type === 'float') values[name] = value();
        if (type === 'bool') values[name] = value() ? 1 : 0;
        if (type === 'point2D') values[name] = [value('X'), value('Y')];
        if (type === 'color') values[name] = [1, 1, 1, 1];
        if (type === 'long') values[name] = choices ? choices[0] : value();
    }
    return values;
}

/// Our picture of a file, with what the page needs in order to draw the same.
function ours(file, number, inputPictures) {
    const job = {file: path.relative(folder, file), source: fs.readFileSync(file, 'latin1'), values: {}, images: {}, imports: {}};
    const vertex = file.replace(/\.fs$/, '.vs');
    if (fs.existsSync(vertex)) job.vertex = fs.readFileSync(vertex, 'latin1');
    try {
        const parameters = JSON.parse(vitrine('list', 'your_shader', '--json', '--set', `your_shader.file=${file}`)).exhibits[0].parameters;
        let head = {};
        try { head = JSON.parse(job.source.match(/\/\*([\s\S]*?)\*\//)[1]); } catch { /* The page says that the head is broken. */ }
        job.values = missingValues(head.INPUTS ?? [], parameters);
        const settings = {};
        for (const {NAME: name} of (head.INPUTS ?? []).filter(input => input.TYPE === 'image')) {
            job.images[name] = `input${Math.min(1, Object.keys(job.images).length)}.png`;
            settings[parameter(parameters, name).name] = inputPictures[Number(job.images[name][5])];
        }
        for (const [name, one] of Object.entries(head.IMPORTED ?? {})) {
            job.imports[name] = `import${number}_${name}`;
            fs.copyFileSync(path.join(path.dirname(file), one.PATH ?? one), path.join(work, job.imports[name]));
        }
        job.picture = `own${number}.png`;
        draw(file, path.join(work, job.picture), settings);
    } catch (error) {
        job.refused = String(error.stderr || error.message).trim().split('\n')[0];
    }
    return job;
}

function listFiles() {
    const all = execFileSync('sh', ['-c', 'find "$0" -name "*.fs" | LC_ALL=C sort', folder], {encoding: 'utf8'}).trim().split('\n');
    return all.filter((file, i) => (i + 1) % step === 0);
}

function stateOf(result) {
    if (result.refused) return 'refused by Vitrine: ' + result.refused;
    if (result.error) return 'not drawn in JavaScript: ' + result.error;
    return result.limits.join('; ');
}

function report(results) {
    const drawn = results.filter(one => !one.refused && !one.error);
    const within = drawn.filter(one => !one.limits.length), near = within.filter(one => one.rmse <= goal);
    const number = value => value?.toFixed(4) ?? '';
    const row = one => `| ${one.file} | ${number(one.rmse)} | ${number(one.atOnce)} | ${stateOf(one).replaceAll('|', '\\|')} |`;
    const table = (title, rows) => rows.length ? `### ${title}\n\n| file | RMSE | flipped at once | notes |\n|---|---|---|---|\n${rows.map(row).join('\n')}\n` : '';
    const percent = (part, all) => `${part} of ${all} (${(100 * part / Math.max(1, all)).toFixed(1)} %)`;
    console.log(`${size.width} x ${size.height} pixels at ${moment} s; shaders with feedback at step ${moment * rate}, ${rate} steps/s. RMSE of 8-bit RGB, of 0..1.
"Flipped at once": the JavaScript renderer, changed by the page so that a pass reads what earlier passes of its frame drew.

| files | number |
|---|---|
| compared | ${results.length} |
| refused by Vitrine | ${results.filter(one => one.refused).length} |
| not drawn by the JavaScript renderer | ${results.filter(one => !one.refused && one.error).length} |
| drawn by both | ${drawn.length} |
| drawn by both, RMSE at most ${goal} | ${percent(drawn.filter(one => one.rmse <= goal).length, drawn.length)} |
| outside the limits of the JavaScript renderer | ${drawn.length - within.length} |
| within its limits | ${within.length} |
| within its limits, RMSE at most ${goal} | ${percent(near.length, within.length)} |
| within its limits, equal pictures | ${within.filter(one => one.rmse === 0).length} |
`);
    console.log(table(`Within the limits, RMSE above ${goal}`, within.filter(one => one.rmse > goal)));
    console.log(table(`Outside the limits, RMSE above ${goal}`, drawn.filter(one => one.limits.length && one.rmse > goal)));
    console.log(table('Not drawn by both', results.filter(one => one.refused || one.error)));
    return near.length >= share * within.length;
}

function compareInBrowser(jobs) {
    return new Promise((resolve, reject) => {
        const results = [];
        let browser;
        const limit = setTimeout(() => end('the page did not finish within ten minutes'), 600000);
        const server = http.createServer((request, response) => {
            if (request.method !== 'POST') {
                const name = path.basename(new URL(request.url, 'http://here').pathname);
                if (name === 'jobs.json') return response.end(JSON.stringify({jobs, size, moment, rate, keep: Boolean(pictures)}));
                response.setHeader('Content-Type', name.endsWith('.html') ? 'text/html' : name.endsWith('.js') ? 'text/javascript' : 'application/octet-stream');
                fs.readFile(path.join(name.endsWith('.html') ? here : work, name), (error, bytes) => response.writeHead(error ? 404 : 200).end(bytes));
                return;
            }
            let body = '';
            request.on('data', part => body += part);
            request.on('end', () => {
                response.end();
                const result = JSON.parse(body);
                if (result.done) return end(result.problem);
                keep(result, jobs[result.number]);
                results.push(result);
                console.error(`${result.rmse === undefined ? '      ' : result.rmse.toFixed(4)} ${result.file}: ${stateOf(result) || 'drawn by both'}`);
            });
        }).listen(0, '127.0.0.1', () => {
            browser = spawn(chromium, ['--headless=new', '--no-sandbox', '--disable-gpu-sandbox', '--use-gl=angle', '--use-angle=gl-egl',
                '--ignore-gpu-blocklist', '--no-first-run', '--disable-background-networking', '--disable-component-update',
                '--user-data-dir=' + path.join(work, 'profile'), `http://127.0.0.1:${server.address().port}/compare_renderers.html`],
                {stdio: 'ignore', detached: true});  // A process group of its own.
        });
        function end(problem) {
            clearTimeout(limit);
            try { process.kill(-browser.pid, 'SIGKILL'); } catch { /* It has ended. */ }
            server.closeAllConnections();
            server.close();
            if (problem) reject(new Error(problem));
            else setTimeout(() => resolve(results), 500);
        }
    });
}

/// Puts both pictures into the folder that the user named.
function keep(result, job) {
    const {picture} = result;
    delete result.picture;
    if (!pictures) return;
    fs.mkdirSync(pictures, {recursive: true});
    const base = path.join(pictures, result.file.replaceAll('/', '_').replace(/\.fs$/, ''));
    if (picture) fs.writeFileSync(base + '-javascript.png', Buffer.from(picture.split(',')[1], 'base64'));
    if (!job.refused) fs.copyFileSync(path.join(work, job.picture), base + '-vitrine.png');
}

const inputPictures = drawInputs();
const jobs = listFiles().map((file, number) => ours(file, number, inputPictures));
process.exitCode = report(await compareInBrowser(jobs)) ? 0 : 1;
