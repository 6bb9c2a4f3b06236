// Types of the program's answers, for editors and the type checker; there is no code here.

/**
 * @typedef {{path: string, sentence: string}} Mistake
 * @typedef {{y: number[], relief_um: (number | null)[], range_um: [number, number]}} Relief
 * @typedef {{a?: Relief, b?: Relief}} Profiles
 * @typedef {{
 *   max_pressure: number, max_pressure_y: number, largest: string,
 *   approach: number, penetration: number, load: number, tilt: number, moment: number, max_half_width: number,
 * }} Key
 * @typedef {{
 *   ok: true, title: string, ms: number, status: string, complaint: string, warnings: string[],
 *   verdict: {level: string, words: string, sentence: string} | null,
 *   summary: [string, string, string][], key: Key, profiles: Profiles,
 *   figures: Record<"pressure" | "footprint" | "distance", import("./panel.js").Figure>,
 *   bodies: Record<"a" | "b", import("./sketch.js").Seen>,
 *   life: {relative: number | null, million_revolutions: number | null, body: string, ends_counted: boolean} | null,
 *   singular: boolean,
 *   stress_note?: string,
 *   body?: "a" | "b",
 *   planes?: Record<"axial" | "section", import("./panel.js").Figure>,
 *   stress?: {body: string, von_mises: {max: number, x: number, y: number, z: number, at_bore: boolean}, searched?: boolean},
 * }} Answer
 * @typedef {{ok: false, mistakes: Mistake[], profiles?: Profiles}} Refusal
 * @typedef {{
 *   id: number, name: string, document: object, answer: any, stressed?: Answer | null,
 *   rename: (name: string) => void, open: () => void, remove: () => void,
 * }} Pin
 */

export {};
