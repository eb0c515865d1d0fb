// Serves the page and what it reads on a port of this machine, opens it in headless Chromium, and prints the result that it
// sends back as one line of JSON.
//   node run.mjs ROOT_OF_THE_SOURCE FOLDER_OF_THREE CHROMIUM [FRAMES] [FOLDER_FOR_PICTURES]
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';

const [source, three, chromium, frames = '20', pictures] = process.argv.slice(2);
const types = {'.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.png': 'image/png'};
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'vitrine-web-hall-'));
let browser;

/// Whether any process of the browser is left: its helpers outlive it, and write to the profile until they end.
function browserRuns() {
    try {
        process.kill(-browser.pid, 0);
        return true;
    } catch {
        return false;
    }
}

async function end(code) {
    clearTimeout(limit);
    if (browser?.pid) {
        if (browserRuns()) process.kill(-browser.pid, 'SIGKILL');
        for (let waited = 0; browserRuns() && waited < 5000; waited += 50) await new Promise(done => setTimeout(done, 50));
    }
    fs.rmSync(profile, {recursive: true, force: true, maxRetries: 20, retryDelay: 100});
    process.exit(code);
}

function take(result) {
    if (result.error) {
        console.error('web_hall: the page failed: ' + result.error);
        return end(1);
    }
    for (const [name, view] of Object.entries(result.views)) {
        if (pictures) fs.writeFileSync(path.join(pictures, name.replaceAll(' ', '_') + '.png'), Buffer.from(view.picture.split(',')[1], 'base64'));
        delete view.picture;
    }
    console.log(JSON.stringify(result));
    end(0);
}

const server = http.createServer((request, response) => {
    if (request.method === 'POST') {
        let body = '';
        request.on('data', part => body += part);
        request.on('end', () => {
            response.end();
            take(JSON.parse(body));
        });
        return;
    }
    const wanted = path.normalize(decodeURIComponent(new URL(request.url, 'http://here').pathname));
    const file = wanted.startsWith('/three/') ? path.join(three, wanted.slice(7))
        : wanted.startsWith('/assets/') ? path.join(source, wanted) : path.join(source, 'tests/bench/web_hall', wanted);
    fs.readFile(file, (error, bytes) => {
        response.writeHead(error ? 404 : 200, {'Content-Type': types[path.extname(file)] ?? 'application/octet-stream'});
        response.end(bytes);
    });
});

const limit = setTimeout(() => {
    console.error('web_hall: the page sent nothing within five minutes');
    end(1);
}, 300000);
server.listen(0, '127.0.0.1', () => {
    const page = `http://127.0.0.1:${server.address().port}/page.html?frames=${frames}`;
    browser = spawn(chromium, ['--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
        '--disable-component-update', '--disable-sync', '--ignore-gpu-blocklist', '--enable-unsafe-swiftshader', '--disable-frame-rate-limit',
        ...(process.env.WEB_HALL_GL ?? '--use-gl=angle --use-angle=gl-egl').split(' '),
        '--user-data-dir=' + profile, page], {stdio: 'ignore', detached: true});  // A process group of its own.
});
