// The styles of live.js and compare.js, which live.py and page.py write in front of them.
declare const LIVE_CSS: string;
declare const COMPARE_CSS: string;
