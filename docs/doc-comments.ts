/** What the doc comments of a TypeScript file say, as parts of a custom elements manifest. */
import { readdirSync, readFileSync } from 'node:fs';
import type { ClassMethod, CustomElementField, Event } from 'custom-elements-manifest/schema';
import ts from 'typescript';

type Member = (CustomElementField | ClassMethod) & { readonly type?: { text: string } };

const parse = (path: string): ts.SourceFile =>
  ts.createSourceFile(path, readFileSync(path, 'utf8'), ts.ScriptTarget.ES2022, true);

/** All sources of a folder, one after the other. */
export const textOfAll = (folder: string): string =>
  readdirSync(folder)
    .map((file) => readFileSync(`${folder}/${file}`, 'utf8'))
    .join('\n');

/** Lines of a comment are broken where the page ends, not where the sentence does. */
const oneLine = (text: string): string => text.replace(/\s*\n\s*/g, ' ').trim();

const docOf = (node: ts.Node): string =>
  ts
    .getJSDocCommentsAndTags(node)
    .filter(ts.isJSDoc)
    .map(({ comment }) => oneLine(ts.getTextOfJSDocComment(comment) ?? ''))
    .join(' ');

function declarationOf(path: string, name: string): ts.ClassDeclaration | ts.InterfaceDeclaration {
  const found = parse(path).statements.find(
    (node): node is ts.ClassDeclaration | ts.InterfaceDeclaration =>
      (ts.isClassDeclaration(node) || ts.isInterfaceDeclaration(node)) && node.name?.text === name,
  );
  if (!found) throw new Error(`${path} has no ${name}`);
  return found;
}

interface Tag {
  readonly name: string;
  readonly description: string;
}

/** What is said of a class, and by name of a tag (`slot`, `csspart`, …) what it lists; the slot without a name is `''`. */
export function tagsOf(path: string, name: string): { description: string; tags: (kind: string) => Tag[] } {
  const declaration = declarationOf(path, name);
  const all = ts.getJSDocTags(declaration).map((tag) => ({
    kind: tag.tagName.text,
    text: oneLine(ts.getTextOfJSDocComment(tag.comment) ?? ''),
  }));
  const tagOf = (text: string): Tag => {
    const [, named = '', description = ''] = /^(\S*?)\s*- (.*)$/.exec(text) ?? [];
    return { name: named, description };
  };
  return {
    description: docOf(declaration),
    tags: (kind) => all.filter((tag) => tag.kind === kind).map(({ text }) => tagOf(text)),
  };
}

const has = (node: ts.ClassElement, kind: ts.SyntaxKind): boolean =>
  ts.canHaveModifiers(node) && (ts.getModifiers(node) ?? []).some((modifier) => modifier.kind === kind);

const HIDDEN = [ts.SyntaxKind.StaticKeyword, ts.SyntaxKind.OverrideKeyword, ts.SyntaxKind.ProtectedKeyword];

/** What people may read, set and call on an object of a class. */
export function membersOf(path: string, name: string): Member[] {
  const declaration = declarationOf(path, name) as ts.ClassDeclaration;
  const shown = declaration.members.filter(
    (node) => node.name && ts.isIdentifier(node.name) && !HIDDEN.some((kind) => has(node, kind)),
  );
  const setters = new Set(shown.filter(ts.isSetAccessor).map((node) => node.name.getText()));
  return shown.flatMap((node): Member[] => {
    const member = { name: node.name?.getText() ?? '', description: docOf(node) };
    if (ts.isMethodDeclaration(node)) return [{ kind: 'method', ...member, ...signatureOf(node) }];
    if (!ts.isPropertyDeclaration(node) && !ts.isGetAccessor(node)) return [];
    const readonly = ts.isGetAccessor(node) && !setters.has(member.name);
    return [{ kind: 'field', ...member, type: { text: node.type?.getText() ?? '' }, ...(readonly && { readonly }) }];
  });
}

function signatureOf({ parameters, type }: ts.MethodDeclaration): Pick<ClassMethod, 'parameters' | 'return'> {
  return {
    parameters: parameters.map((parameter) => ({
      name: parameter.name.getText(),
      type: { text: parameter.type?.getText() ?? '' },
      ...(parameter.questionToken && { optional: true }),
    })),
    return: { type: { text: type?.getText() ?? '' } },
  };
}

/** The events of the interface `OwnEvents`, which lists their classes by name. */
export function eventsOf(path: string): Event[] {
  const { members } = declarationOf(path, 'OwnEvents') as ts.InterfaceDeclaration;
  return members.filter(ts.isPropertySignature).map((node) => {
    const type = node.type?.getText() ?? '';
    return { name: node.name.getText(), type: { text: type }, description: docOf(declarationOf(path, type)) };
  });
}
