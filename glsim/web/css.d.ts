// The style of live.js, which live.py writes in front of it.
declare const LIVE_CSS: string;
