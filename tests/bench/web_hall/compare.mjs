// Measures the page and the case hall_costs in turn, and prints one table of wall times.
//   node compare.mjs ROOT_OF_THE_SOURCE FOLDER_OF_THREE CHROMIUM BENCH [ROUNDS]
import {execFileSync} from 'node:child_process';
import path from 'node:path';
import {fileURLToPath} from 'node:url';

const [source, three, chromium, bench, rounds = '3'] = process.argv.slice(2);
const here = path.dirname(fileURLToPath(import.meta.url));
const views = ['towards the door', 'from the entrance'];

function page() {
    const printed = execFileSync('node', [path.join(here, 'run.mjs'), source, three, chromium], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit']});
    return JSON.parse(printed);
}

// Medians of its own rounds: the column "ms (wall)".
function ours() {
    const rows = execFileSync(bench, ['hall_costs'], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'inherit']}).split('\n').map(line => line.split('|').map(cell => cell.trim()));
    const column = rows.find(row => row.includes('ms (wall)') && row[1] === 'what').indexOf('ms (wall)');
    return Object.fromEntries(views.map(view => [view, Number(rows.find(row => row[1] === 'empty hall, ' + view)[column])]));
}

const median = numbers => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
const range = numbers => `${Math.min(...numbers).toFixed(0)} to ${Math.max(...numbers).toFixed(0)}`;

const web = [];
const own = [];
for (let i = 0; i < Number(rounds); ++i) {
    web.push(page());
    own.push(ours());
}
console.log(`The empty hall at 640 x 360, ${rounds} rounds in turn, medians of wall time; web: three.js r${web[0].revision}, ${web[0].renderer}, ${web[0].triangles} triangles\n`);
console.log('| view | web, ms | rounds | ours, ms | rounds | ours over web |\n|---|---|---|---|---|---|');
for (const view of views) {
    const theirs = web.map(result => median(result.views[view].times));
    const mine = own.map(result => result[view]);
    console.log(`| ${view} | ${median(theirs).toFixed(1)} | ${range(theirs)} | ${median(mine).toFixed(1)} | ${range(mine)} | ${(median(mine) / median(theirs)).toFixed(2)} |`);
}
