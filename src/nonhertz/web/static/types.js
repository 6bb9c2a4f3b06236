// Types of the program's answers, for editors and the type checker; there is no code here.

/**
 * @typedef {{path: string, sentence: string}} Mistake
 * @typedef {Record<string, import("./panel.js").Figure>} Profiles
 * @typedef {{
 *   max_pressure: number, max_pressure_y: number,
 *   approach: number, penetration: number, load: number, tilt: number, moment: number, max_half_width: number,
 * }} Key
 * @typedef {{
 *   ok: true, title: string, ms: number, status: string, complaint: string, warnings: string[],
 *   verdict: {level: string, words: string, sentence: string} | null,
 *   summary: [string, string, string][], numbers: import("./results.js").KeyNumber[], key: Key, profiles: Profiles,
 *   figures: Record<"pressure" | "footprint" | "distance", import("./panel.js").Figure>,
 *   bodies: Record<"a" | "b", import("./sketch.js").Seen>,
 *   stress_note?: string,
 *   body?: "a" | "b",
 *   planes?: Record<"axial" | "section", import("./panel.js").Figure>,
 *   stress?: import("./results.js").KeyNumber,
 * }} Answer
 * @typedef {{values: Record<string, any>, sentences: string[]}} Estimates values of a document by their paths
 * @typedef {{ok: false, mistakes: Mistake[], profiles?: Profiles}} Refusal
 * @typedef {{
 *   id: number, name: string, document: object, answer: any, stressed?: Answer | null,
 *   rename: (name: string) => void, open: () => void, remove: () => void,
 * }} Pin
 */

export {};
